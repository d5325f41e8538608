#pragma once

#include <glm/vec3.hpp>
#include <utility>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Where an object stands: scaled, then turned about x, y and z in this order, then moved.
struct Placement {
  glm::dvec3 scale{1.0};
  glm::dvec3 turn_degrees{0.0};  // right-handed
  glm::dvec3 position{0.0};
};

/// The mesh in world space. Turns by multiples of 90 degrees are exact.
Mesh placed(Mesh mesh, const Placement& placement);

/// The corners of the smallest axis-aligned box round the mesh; the mesh has a vertex.
std::pair<glm::dvec3, glm::dvec3> bounds_of(const Mesh& mesh);

/// The mesh scaled alike in all directions until its largest extent is `size`, standing on y = 0
/// with its middle on the y axis.
/// \throws InputError if the mesh has no extent
Mesh fitted(Mesh mesh, double size);

}  // namespace wedgesim::functional
