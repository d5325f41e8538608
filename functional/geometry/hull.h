#pragma once

#include <glm/vec2.hpp>
#include <vector>

namespace wedgesim::functional {

/// Indices of the corners of the convex hull, counter-clockwise (x right, y up), without points on
/// its sides (Andrew's monotone chain).
std::vector<std::size_t> convex_hull_indices(const std::vector<glm::dvec2>& points);
std::vector<glm::dvec2> convex_hull(const std::vector<glm::dvec2>& points);

}  // namespace wedgesim::functional
