#pragma once

#include <cstddef>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// How many lights a scene has, at least 1.
inline std::size_t light_count(const Scene& scene) { return 1 + scene.other_lights.size(); }

/// A light of a scene: 0 is `scene.light`, then `scene.other_lights` in order.
const Light& light_at(const Scene& scene, std::size_t i);

/// The scene lit by its i-th light alone, which is what traces and shadow methods treat.
Scene with_light(const Scene& scene, std::size_t i);

}  // namespace wedgesim::functional
