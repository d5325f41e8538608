#pragma once

#include <glm/vec3.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The point that a scene's coordinates are best taken from: the eye if all of it is many times its
/// own size away from the world's origin, so that differences of its coordinates lose digits, else
/// the world's origin.
glm::dvec3 best_origin(const Scene& scene);

/// The scene with every position taken from another origin; each difference is rounded once, by at
/// most half a unit in its own last place.
Scene taken_from(const Scene& scene, const glm::dvec3& origin);

}  // namespace wedgesim::functional
