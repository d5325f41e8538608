#pragma once

#include <filesystem>
#include <glm/vec3.hpp>
#include <vector>

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

/// What a light's table needs besides itself.
struct LightContext {
  std::filesystem::path folder;  // that names of textures start at
  int frame = 0;                 // of the camera path: frame i shows texture i mod their number
};

/// Reads [light]: shape = "rectangle" (size, target and roll, or half_u and half_v), "sphere"
/// (radius, target) or "point".
/// A rectangle may have `textures`, names of images, or `fire` (frames, side, seed).
/// \throws InputError at FILE:LINE, or naming an image that cannot be read
LightFile read_light(const TomlTable& table, const LightContext& context = {});

/// The images that a light's table names.
std::vector<std::filesystem::path> light_textures(const TomlTable& table,
                                                  const std::filesystem::path& folder);

/// The light in another shape, as SceneOptions::light_shape says; one without extent has none in
/// any.
Light reshaped(const LightFile& file, LightShape shape);

}  // namespace wedgesim::functional
