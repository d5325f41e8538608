#pragma once

#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>

#include "functional/scene/scene_file.h"

namespace wedgesim::cli {

/// The arguments that choose a scene, the same for every command that renders one.
struct SceneArguments {
  std::string scene, size, frame = "0", mesh, light;
  bool repair = false;

  void add_to(CLI::App& app);
  /// All but the scene itself.
  void add_options_to(CLI::App& app);
  /// Loads the scene; what a repair did is said on standard error.
  /// \param output  what will be written
  /// \throws InputError for anything wrong with the options or the scene, or if the scene is read
  ///         from `output`
  functional::Scene load(const std::filesystem::path& output) const;
};

}  // namespace wedgesim::cli
