#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "functional/geometry/extent.h"
#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// The convex polyhedron inside all planes (n·p + d ≥ 0) and inside a box. Faces on the box carry
/// the box's planes, appended after the given ones where they are needed.
/// \param accuracy  length by which rounding may move vertices; 0: by no more than they are rounded
/// \return          no faces if nothing is inside
WorldWedge intersect_half_spaces(std::span<const glm::dvec4> planes, const Bounds& box,
                                 double accuracy = 0.0);

}  // namespace wedgesim::functional
