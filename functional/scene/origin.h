#pragma once

#include <glm/vec3.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The point that a scene's coordinates are best taken from: the world's origin, unless differences
/// of coordinates would lose digits from there, because the scene is many times its own size away
/// from it, or the light or the eye a thousand times farther than from a caster. Then the light's
/// centre or the eye, whichever is nearer to a caster.
glm::dvec3 best_origin(const Scene& scene);

/// The scene with every position taken from another origin; each difference is rounded once, by at
/// most half a unit in its own last place.
Scene taken_from(const Scene& scene, const glm::dvec3& origin);

}  // namespace wedgesim::functional
