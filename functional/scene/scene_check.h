#pragma once

#include <string>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What every renderer may take for granted about a scene: objects with triangles and finite
/// coordinates; no light inside a closed object or touching one; every caster strictly in front of
/// the plane of a rectangular light.
/// \param place  named in the error
/// \throws InputError naming the object
void check_scene(const Scene& scene, const std::string& place);

}  // namespace wedgesim::functional
