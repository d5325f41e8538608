#pragma once

#include <cstddef>
#include <vector>

#include "functional/methods/frame.h"
#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// The judge's LI of the pixels of a frame that show a surface, units of full light.
class Judged {
 public:
  /// Both must outlive it.
  Judged(const Case& stress_case, const functional::Frame& frame);

  const std::vector<std::size_t>& pixels() const { return pixels_; }  // indices into the frame
  double li(std::size_t k) const { return li_[k]; }                   // of pixels()[k]
  /// Exact where it was asked for, else the renderer's.
  double sensitivity(std::size_t k) const { return sensitivity_[pixels_[k]]; }
  const std::vector<double>& sensitivities() const { return sensitivity_; }  // (height, width)
  double seconds() const { return seconds_; }  // of one thread, for li()

  /// Makes the sensitivity of some pixels exact. Others keep the renderer's.
  /// \param wanted  positions in pixels()
  void refine(const std::vector<std::size_t>& wanted);

 private:
  const Case& case_;
  const functional::Frame& frame_;
  std::vector<std::size_t> pixels_;
  std::vector<double> li_;
  double seconds_ = 0.0;
  std::vector<double> sensitivity_;  // of the frame
};

}  // namespace wedgesim::reports::stress
