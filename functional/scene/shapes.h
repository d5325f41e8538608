#pragma once

#include <filesystem>
#include <optional>
#include <vector>

#include "base/toml_table.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What a shape may depend on besides its own table.
struct ShapeContext {
  std::filesystem::path folder;                         // relative paths start here
  std::optional<std::filesystem::path> user_mesh;       // --mesh
  std::vector<std::filesystem::path>* files = nullptr;  // gets the meshes and fonts that are read
};

/// The mesh that the key `shape` and the shape's own keys describe, in its own space.
/// \throws InputError at FILE:LINE
Mesh read_shape(const TomlTable& table, const ShapeContext& context);

}  // namespace wedgesim::functional
