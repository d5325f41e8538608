#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "functional/scene/scene.h"
#include "functional/scene/toml_table.h"

namespace wedgesim::functional {

/// What an object's meshes may depend on besides its own table.
struct ObjectContext {
  std::filesystem::path folder;  // relative paths start here
  std::optional<std::filesystem::path> user_mesh;
  bool repair = false;
  std::vector<std::string>* notes = nullptr;
};

/// The objects of one [[object]] table: one for each position. Casters are welded and closed.
/// \throws InputError at FILE:LINE, or naming the mesh
std::vector<Object> read_objects(const TomlTable& table, const ObjectContext& context);

}  // namespace wedgesim::functional
