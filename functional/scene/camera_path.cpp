#include "functional/scene/camera_path.h"

#include <algorithm>

#include "base/check.h"

namespace wedgesim::functional {
namespace {

glm::dvec3 catmull_rom(glm::dvec3 before, glm::dvec3 from, glm::dvec3 to, glm::dvec3 after,
                       double t) {
  const glm::dvec3 a = 2.0 * from;
  const glm::dvec3 b = to - before;
  const glm::dvec3 c = 2.0 * before - 5.0 * from + 4.0 * to - after;
  const glm::dvec3 d = 3.0 * from - before - 3.0 * to + after;
  return 0.5 * (a + t * (b + t * (c + t * d)));
}

}  // namespace

int frame_count(const std::vector<CameraKey>& keys) {
  int frames = 1;
  for (std::size_t i = 0; i + 1 < keys.size(); ++i) {
    frames += keys[i].frames;
  }
  return frames;
}

Camera camera_at(const Camera& camera, const std::vector<CameraKey>& keys, Interpolation way,
                 int frame) {
  CHECK_GE(frame, 0);
  CHECK_LT(frame, frame_count(keys));
  if (keys.empty()) {
    return camera;
  }
  std::size_t i = 0;
  while (i + 1 < keys.size() && frame >= keys[i].frames) {
    frame -= keys[i].frames;
    ++i;
  }
  Camera at = camera;
  if (i + 1 == keys.size()) {
    at.eye = keys[i].eye;
    at.target = keys[i].target;
    return at;
  }
  const double t = static_cast<double>(frame) / keys[i].frames;
  const CameraKey& from = keys[i];
  const CameraKey& to = keys[i + 1];
  if (way == Interpolation::linear) {
    at.eye = from.eye + t * (to.eye - from.eye);
    at.target = from.target + t * (to.target - from.target);
  } else {
    const CameraKey& before = keys[i == 0 ? 0 : i - 1];
    const CameraKey& after = keys[std::min(i + 2, keys.size() - 1)];
    at.eye = catmull_rom(before.eye, from.eye, to.eye, after.eye, t);
    at.target = catmull_rom(before.target, from.target, to.target, after.target, t);
  }
  return at;
}

}  // namespace wedgesim::functional
