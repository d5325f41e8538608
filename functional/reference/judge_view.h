#pragma once

#include <cstdint>

#include "functional/reference/real.h"
#include "functional/scene/scene.h"
#include "traces/depth.h"

namespace wedgesim::functional {

/// The window depth of a stored word, without any rounding of double.
Real judged_depth(traces::fb::DepthFormat format, std::uint32_t word);

/// A camera in 200 bits, from the camera as it was given; window.h has the conventions.
class JudgedView {
 public:
  JudgedView(const Camera& camera, int width, int height);
  const RealVector& eye() const { return eye_; }
  /// From the eye to the point at a pixel's centre and a window depth, world axes and units.
  RealVector from_eye(std::size_t pixel, const Real& z) const;

 private:
  int width_;
  RealVector eye_, right_, down_, forward_;
  Real near_, far_, half_width_, half_height_, pixels_per_unit_;
};

}  // namespace wedgesim::functional
