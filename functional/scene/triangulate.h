#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <vector>

namespace wedgesim::functional {

/// A point of a polygon; coordinates below 2^28, so that every predicate is exact.
using GridPoint = glm::i64vec2;

/// Triangulates a polygon with holes by bridging each hole to what is round it and clipping ears.
/// No vertex is added, and every edge of a contour is an edge of exactly one triangle.
/// \param points    of all contours
/// \param contours  indices into points: first the outside, counter-clockwise, then the holes,
///                  clockwise; simple, at least 3 points each, not touching each other
/// \return          counter-clockwise triangles of positive area whose areas add up to the
///                  polygon's; none if the contours are not what they should be
std::vector<std::array<std::uint32_t, 3>> triangulate(
    const std::vector<GridPoint>& points, const std::vector<std::vector<std::uint32_t>>& contours);

/// Twice the area of a contour, positive if it is counter-clockwise.
std::int64_t doubled_area(const std::vector<GridPoint>& points,
                          const std::vector<std::uint32_t>& contour);

}  // namespace wedgesim::functional
