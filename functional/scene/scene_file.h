#pragma once

#include <filesystem>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What the command line may change in a scene.
struct SceneOptions {
  std::optional<std::pair<int, int>> size;    // pixels, 1 to kMaxFrameEdge each way
  int frame = 0;                              // of the camera path
  std::optional<std::filesystem::path> mesh;  // takes the place of the object with shape = "user"
  bool repair = false;                        // repair every caster that is not closed
  /// Turns the lights into another shape: a sphere of radius (|half_u| + |half_v|) / 2, a square of
  /// half axes as long as the radius that faces the light's target, or its centre alone.
  std::optional<LightShape> light_shape;
  double light_scale = 1.0;       // of the light's half axes or radius, above 0
  std::optional<int> field_side;  // copies each way of objects with a field, 1 to kMostFieldSide
};
inline constexpr int kMostFieldSide = 200;

struct SceneInfo {
  std::string name;
  std::string description;
  int frames = 1;  // of the camera path
};

/// Reads one frame of a scene; traces/scenes/README.md describes the format. Casters come out
/// welded (equal positions are one vertex) and checked; the whole scene is checked (scene_check.h).
/// \param name_or_file  a built-in name, or a TOML file if it ends in .toml or names a folder
/// \param notes         may be null; gets a line for each thing that a repair did
/// \throws InputError   for anything wrong with the file, its meshes or the options
Scene load_scene(const std::string& name_or_file, const SceneOptions& options = {},
                 std::vector<std::string>* notes = nullptr);

/// What a scene is made from.
struct SceneSource {
  std::string name;
  std::string text;                          // of its file
  std::vector<std::filesystem::path> files;  // its own, unless built in, meshes and fonts
  int width = 640, height = 427;
  int frames = 1;          // of the camera path
  bool has_field = false;  // an object says how many copies of it there are
};

/// What can be known of a scene without its meshes, which need not be there.
/// \throws InputError if there is no such scene, or if its file, its size or its camera is wrong
SceneSource scene_source(const std::string& name_or_file);

/// The scenes inside the program, by name.
std::vector<SceneInfo> built_in_scenes();

}  // namespace wedgesim::functional
