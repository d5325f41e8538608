#pragma once

#include <cstdint>
#include <random>

#include "functional/scene/scene.h"

namespace wedgesim::tests {

/// What the eye of a random scene is near to.
enum class EyePlace { outside, in_shadow };

/// A small frame of random closed meshes (deformed spheres and tori, prisms over star-shaped
/// polygons, tetrahedra) over a bumpy floor, with a random light above and a random camera. The
/// same seed gives the same scene.
functional::Scene random_scene(std::uint64_t seed, EyePlace place);

}  // namespace wedgesim::tests
