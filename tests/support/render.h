#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::test {

/// A small frame of a built-in scene, without its expected LI.
/// \param light  the scene's own if not given
inline traces::Trace render(const std::string& scene, traces::fb::WedgeKind kind,
                            std::pair<int, int> size,
                            std::optional<functional::LightShape> light = {}) {
  functional::SceneOptions scene_options;
  scene_options.size = size;
  scene_options.light_shape = light;
  std::vector<std::string> notes;
  functional::FrameOptions options;
  options.kind = kind;
  options.expected_li = false;
  return functional::make_frame(functional::load_scene(scene, scene_options, &notes), options)
      .trace;
}

}  // namespace wedgesim::test
