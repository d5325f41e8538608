#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <optional>
#include <span>

#include "functional/methods/frame.h"
#include "reports/stress/errors.h"
#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

struct Jumps {
  std::optional<Jump> largest;   // none where no step was found, or looked for
  std::uint64_t not_finite = 0;  // contributions at the moved points that are no number
};

/// Puts stored depths on either side of a plane of a wedge, another at each of some pixels, and
/// compares how LI steps from one to the other.
/// \param pixels  that show a surface; a few of them are taken
/// \return        by Arithmetic; nothing of the renderer
std::array<Jumps, kArithmetics.size()> largest_jumps(const Case& stress_case,
                                                     const functional::Frame& frame,
                                                     std::span<const std::size_t> pixels);

}  // namespace wedgesim::reports::stress
