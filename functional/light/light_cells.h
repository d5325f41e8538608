#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The middles of a square number of equal cells of a light. A sphere is taken as the disc through
/// its centre that faces `towards`; a point is there once.
/// \param count  rounded down to a square number, at least 1
std::vector<glm::dvec3> cell_middles(const Light& light, int count, const glm::dvec3& towards);

/// A rectangle cut into side x side equal lights.
std::vector<Light> light_parts(const Light& light, int side);

}  // namespace wedgesim::functional
