#pragma once

#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

enum class Interpolation { linear, catmull_rom };

/// One point that a camera's path passes through.
struct CameraKey {
  glm::dvec3 eye{0.0};
  glm::dvec3 target{0.0};
  int frames = 0;  // from this key to the next
};

/// Frames of a path: every key but the last gives its `frames`, the last key one; 1 without keys.
int frame_count(const std::vector<CameraKey>& keys);

/// The camera of one frame: `camera` with the path's eye and target; `camera` itself without keys.
/// Catmull-Rom is uniform, with the end keys repeated.
/// \param frame  from 0 to frame_count(keys) - 1, checked
Camera camera_at(const Camera& camera, const std::vector<CameraKey>& keys, Interpolation way,
                 int frame);

}  // namespace wedgesim::functional
