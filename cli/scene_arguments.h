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
  /// Whether no option changes the scene.
  bool is_default() const {
    return size.empty() && frame == "0" && mesh.empty() && light.empty() && !repair;
  }
  /// Loads the scene; what a repair did is said on standard error.
  /// \param output  what will be written
  /// \throws InputError for anything wrong with the options or the scene, or if the scene is read
  ///         from `output`
  functional::Scene load(const std::filesystem::path& output) const;
};

/// The argument that takes one of a scene's lights, for the commands that know but one.
struct LightNumber {
  std::string text;  // empty: not given

  /// \param otherwise  what is done without it
  void add_to(CLI::App& app, const std::string& otherwise);
  /// The scene lit by the chosen light alone, the first if none is.
  /// \throws InputError unless it is the number of a light, from 1
  functional::Scene choose(const functional::Scene& scene) const;
};

}  // namespace wedgesim::cli
