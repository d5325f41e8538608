#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "functional/methods/frame.h"

namespace wedgesim::functional {

/// The light intensity of pixels of a frame as docs/trace.md defines it, in 200-bit arithmetic. The
/// trace gives what is decided once for all: the snapped umbra polygons, their z_min and z_max, the
/// stored depths, the signs of plane references, the method (expected_z_method); the frame's
/// geometry gives which edges and vertices things are made from, and what was decided by comparing
/// (LinearCorner, EndSide, UmbraSource). Everything else comes from the scene as it was given: the
/// camera makes the point of a stored depth, the light and the vertices make planes.
///
/// Penumbra is computed at every pixel before the end plane without the wedge's polygons; a wedge
/// that is too tight or lost shows as an error. Of kind coverage: what an edge hides of the light.
/// Of kind linear: Paper I, section 4, by judge_linear.h.
///
/// A value on a plane is one that is less than 2^-175 of its terms. Degenerate edges: see
/// judge_coverage.h; no input gives a NaN. An edge that hides some of the light from a pixel costs
/// 10 to 20 microseconds, another a hundredth of that.
///
/// \param frame       of this scene, by make_frame
/// \param pixels      indices into the frame's depth, each once; those of the sky mean nothing
/// \param depth_step  0, or the intensity if the stored z were one step nearer (-1) or farther (1)
/// \param seconds     if given, what the sums took, all threads together, is added to it
/// \return            one for each of pixels, not clamped, rounded to double
std::vector<double> judge_light_intensity(const Scene& scene, const Frame& frame,
                                          std::span<const std::size_t> pixels, int depth_step = 0,
                                          double* seconds = nullptr);

/// The same, and the larger change of it when the stored z moves one step up or down.
struct Judgement {
  std::vector<double> li, sensitivity;
};
Judgement judge_with_sensitivity(const Scene& scene, const Frame& frame,
                                 std::span<const std::size_t> pixels);

}  // namespace wedgesim::functional
