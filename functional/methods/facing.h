#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// How a triangle stands to a round light. What casts no shadow does not face away.
enum class Facing : std::uint8_t { light, away_from_its_centre, away };

/// Of each triangle of the scene, as the depth buffer numbers them, the side that the eye sees: of
/// two faces in one place, a thin caster's, the depth buffer may name the other one.
/// \param centre  of the light; \param radius of its sphere, world units, 0 for a point
std::vector<Facing> find_facings(const MethodInput& input, const glm::dvec3& centre, double radius);

}  // namespace wedgesim::functional
