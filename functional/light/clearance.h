#pragma once

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Refuses a caster that touches the light or lies behind a rectangle's plane.
/// \throws InputError naming the mesh and its first vertex that is not clear of the light
void check_light_is_clear(const Mesh& mesh, const Light& light);

}  // namespace wedgesim::functional
