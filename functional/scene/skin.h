#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Joins rings of points into a surface. Each ring has the same number of points, or one: a pole.
/// A ring turns right-handed about the direction in which the rings follow each other; then the
/// triangles are counter-clockwise seen from outside. Closed if it begins and ends with a pole, or
/// if `loop` joins the last ring to the first.
Mesh skin(const std::vector<std::vector<glm::dvec3>>& rings, bool loop = false);

/// Turns a profile round the y axis; ends off the axis are closed by flat faces.
/// \param profile   (n) radius >= 0 and height from the lower end to the upper, n >= 2
/// \param segments  round the axis, at least 3
/// \throws InputError if a radius is negative, or an inner one 0
Mesh make_lathe(const std::vector<glm::dvec2>& profile, int segments);

/// A tube along a path, closed at both ends by flat faces. Frames are carried along without twist.
/// \param path      (n) points of the centre line, n >= 2, no two neighbours equal
/// \param radii     (n) above 0
/// \param segments  round the path, at least 3
Mesh make_sweep(const std::vector<glm::dvec3>& path, const std::vector<double>& radii,
                int segments);

}  // namespace wedgesim::functional
