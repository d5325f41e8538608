#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include "model/count/light_image.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// One pixel of a comparison; LI and errors in units of full light.
struct PixelError {
  int x = 0, y = 0;
  double expected = 0.0;
  double li = 0.0;
  double error = 0.0;        // li - expected
  double sensitivity = 0.0;  // what one step of stored z changes
};

/// A pixel's LI beside the trace's expected LI. Nothing if the trace holds none, or at a sky pixel
/// under the z method that it does not hold for.
/// \param word  in the datapath's words
std::optional<PixelError> compare_pixel(const traces::TraceView& trace, ZMethod method, int x,
                                        int y, std::int64_t word, const Datapath& datapath);

/// The error is within the datapath's tolerance and what one step of stored z explains.
bool matches(const PixelError& pixel, const Datapath& datapath);

/// LI against the trace's expected LI.
struct PixelCheck {
  std::uint64_t compared = 0;  // 0 if the trace holds no expected LI
  double max_error = 0.0;
  double rms_error = 0.0;        // over pixels of sensitivity <= 1/255
  double rms_penumbra = 0.0;     // over those of them that are inside a wedge
  std::uint64_t mismatched = 0;  // |error| > tolerance + sensitivity
  double tolerance = 0.0;
  std::vector<PixelError> worst;  // at most ten, the worst first
};

/// What the finished frame of a configuration says.
struct FrameSummary {
  std::uint64_t li_writes_floor = 0;               // final word not fully lit
  std::uint64_t stencil_not_zero = 0;              // pixels that a merge writes
  std::uint64_t li_out_of_range = 0;               // LI alone: single-pass
  std::uint64_t any_out_of_range = 0;              // LI or stencil: three-pass
  std::uint64_t contributions_max = 0;             // to one pixel
  std::optional<std::array<int, 2>> li_overflow;   // x, y: the first of li_out_of_range
  std::optional<std::array<int, 2>> any_overflow;  // of any_out_of_range
  PixelCheck pixels;
};

/// A frame of LI words: fully lit plus all contributions.
class FinishedFrame {
 public:
  /// \param corrections  of one configuration; empty in a right block
  FinishedFrame(const ZFrame& frame, const LightImage& image, const Datapath& datapath,
                std::vector<Correction> corrections);

  /// \param method  that the frame was made with
  FrameSummary summarize(const traces::TraceView& trace, ZMethod method) const;

  /// (height, width) words; 1.0 is Datapath::one().
  std::vector<std::int64_t> words() const;

 private:
  /// The sums of a block's pixels.
  struct BlockSums {
    std::array<std::int64_t, kBlockPixels> words;
    std::array<std::int32_t, kBlockPixels> stencil;
    std::array<std::uint32_t, kBlockPixels> contributions;
  };
  BlockSums sums(std::size_t block) const;
  /// Calls f(x, y, bit) for the pixels of a block that are in the frame.
  template <typename F>
  void for_each_pixel(std::uint32_t bx, std::uint32_t by, F&& f) const;

  const ZFrame& frame_;
  const LightImage& image_;
  Datapath datapath_;
  std::int64_t one_;
  std::vector<Correction> corrections_;  // one a position, sorted
};

}  // namespace wedgesim::model
