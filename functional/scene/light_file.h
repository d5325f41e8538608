#pragma once

#include <glm/vec3.hpp>

#include "base/toml_table.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A light as its table says, and what it is aimed at, should it become a rectangle.
struct LightFile {
  Light light;
  glm::dvec3 target{0.0};
};

/// A square or rectangle that shines from `centre` at `target`; half_u is horizontal before `roll`.
/// \param half_size     along half_u and half_v, world units
/// \param roll_degrees  right-handed about the direction of light
Light aimed_rectangle(glm::dvec3 centre, glm::dvec3 target, double half_u, double half_v,
                      double roll_degrees = 0.0);

/// Reads [light]: shape = "rectangle" (size, target and roll, or half_u and half_v), "sphere"
/// (radius, target) or "point".
/// \throws InputError at FILE:LINE
LightFile read_light(const TomlTable& table);

/// The light in another shape, as SceneOptions::light_shape says.
Light reshaped(const LightFile& file, LightShape shape);

}  // namespace wedgesim::functional
