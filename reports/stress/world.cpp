#include "reports/stress/world.h"

#include <glm/mat4x4.hpp>

namespace wedgesim::reports::stress {
namespace {

glm::dmat4 matrix(const traces::fb::Matrix4& from) {
  glm::dmat4 m;
  for (int column = 0; column < 4; ++column) {
    for (int row = 0; row < 4; ++row) {
      m[column][row] = (*from.columns())[static_cast<std::uint16_t>(4 * column + row)];
    }
  }
  return m;
}

}  // namespace

glm::dvec4 world_point(const traces::TraceView& trace, double x, double y, double z) {
  return matrix(trace.header.camera.world_from_window) * glm::dvec4(x, y, z, 1.0);
}

glm::dvec4 world_plane(const traces::TraceView& trace, const glm::dvec4& window_plane) {
  return window_plane * matrix(trace.header.camera.window_from_world);
}

}  // namespace wedgesim::reports::stress
