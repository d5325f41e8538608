#pragma once

#include <array>
#include <cstddef>
#include <span>

#include "functional/methods/frame.h"
#include "reports/stress/family.h"
#include "reports/stress/measure.h"

namespace wedgesim::reports::stress {

/// Puts stored depths on either side of a plane of a wedge, another at each of some pixels, and
/// compares how LI steps from one to the other.
/// \param pixels  that show a surface; a few of them are taken
/// \return        by Arithmetic, units of full light: the largest error of a step beyond the
///                sensitivity of both sides; 0 of the renderer and where no step was found
std::array<double, kArithmetics.size()> largest_jumps(const Case& stress_case,
                                                      const functional::Frame& frame,
                                                      std::span<const std::size_t> pixels);

}  // namespace wedgesim::reports::stress
