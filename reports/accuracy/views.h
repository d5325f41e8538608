#pragma once

#include <array>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "functional/scene/scene_file.h"

namespace wedgesim::reports::accuracy {

/// A scene with what is changed in it, by a name of its own.
struct View {
  std::string name;   // "torus-224 300x300"
  std::string scene;  // built-in
  functional::SceneOptions options;
  std::optional<std::array<int, 2>> torus;  // segments round the axis and the tube
  int subdivide = 0;
  double light_away = 1.0;  // as many times as far from the world's origin, and as large
  bool published = false;   // it has the size of a scene in a paper's table

  /// \param meshes  where relative paths of meshes start
  /// \return nothing if its mesh is not there
  std::optional<functional::Scene> load(const std::filesystem::path& meshes) const;
};

/// \param file  the name that errors give
/// \throws InputError at FILE:LINE
std::vector<View> parse_views(std::string_view text, const std::string& file);

/// reports/accuracy/views.toml, compiled in.
const std::vector<View>& built_in_views();
struct BuiltInViews {
  std::string_view name, text;
};
std::span<const BuiltInViews> built_in_view_files();

}  // namespace wedgesim::reports::accuracy
