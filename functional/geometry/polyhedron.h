#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "functional/geometry/extent.h"
#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// The convex polyhedron inside all planes (n·p + d ≥ 0) and inside a box. Faces on the box carry
/// the box's planes, appended after the given ones where they are needed.
/// \param planes    with unit normals, or nearly so: how far rounding puts a vertex off a plane is
///                  a length
/// \param accuracy  length by which rounding may move vertices. Double precision serves where that
///                  is enough and no vertex is on a plane but for rounding; else, and so always
///                  with 0, quadruple precision
/// \return          no faces if nothing is inside
WorldWedge intersect_half_spaces(std::span<const glm::dvec4> planes, const Bounds& box,
                                 double accuracy = 0.0);

}  // namespace wedgesim::functional
