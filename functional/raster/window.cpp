#include "functional/raster/window.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "functional/raster/exact_cross.h"

namespace wedgesim::functional {

Window make_window(const Camera& camera, int width, int height) {
  const double near = camera.near_plane;
  const double far = camera.far_plane;
  if (!(near > 0.0 && far > near && std::isfinite(far))) {
    throw InputError("camera", "near and far planes are out of order", "0 < near < far");
  }
  const glm::dvec3 view = camera.target - camera.eye;
  const glm::dvec3 side = exact_cross({camera.target, camera.eye}, Difference(camera.up));
  if (!(glm::length(view) > 0.0 && glm::length(side) > 1e-9 * glm::length(view))) {
    throw InputError("camera", "the view direction is zero or along up",
                     "another eye, target or up");
  }
  const glm::dvec3 forward = glm::normalize(view);
  const glm::dvec3 right = glm::normalize(side);
  const glm::dvec3 down = glm::cross(forward, right);
  const double tan_half = std::tan(glm::radians(camera.field_of_view_degrees) / 2.0);
  const double pixels_per_unit = 0.5 * height / tan_half;  // at distance 1

  // World to eye (right, down, forward), then to the window; both ways in closed form.
  glm::dmat4 eye_from_world(1.0);
  glm::dmat4 world_from_eye(1.0);
  const std::array<glm::dvec3, 3> axes{right, down, forward};
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& axis = axes[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) eye_from_world[j][i] = axis[j];
    eye_from_world[3][i] = -glm::dot(axis, camera.eye);
    world_from_eye[i] = glm::dvec4(axis, 0.0);
  }
  world_from_eye[3] = glm::dvec4(camera.eye, 1.0);

  // x = s·X + (w/2)·Z, z = zs·Z + zt, w = Z, all divided by Z later.
  const double half_width = 0.5 * width;
  const double half_height = 0.5 * height;
  const double z_scale = far / (far - near);
  const double z_shift = -far * near / (far - near);
  glm::dmat4 window_from_eye(0.0);
  window_from_eye[0][0] = pixels_per_unit;
  window_from_eye[1][1] = pixels_per_unit;
  window_from_eye[2] = glm::dvec4(half_width, half_height, z_scale, 1.0);
  window_from_eye[3][2] = z_shift;
  glm::dmat4 eye_from_window(0.0);
  eye_from_window[0][0] = 1.0 / pixels_per_unit;
  eye_from_window[1][1] = 1.0 / pixels_per_unit;
  eye_from_window[2][3] = 1.0 / z_shift;
  eye_from_window[3] = glm::dvec4(-half_width / pixels_per_unit, -half_height / pixels_per_unit,
                                  1.0, -z_scale / z_shift);

  Window window;
  window.width = width;
  window.height = height;
  window.window_from_world = window_from_eye * eye_from_world;
  window.world_from_window = world_from_eye * eye_from_window;
  window.eye = camera.eye;
  window.ray_from_window[0] = right / pixels_per_unit;
  window.ray_from_window[1] = down / pixels_per_unit;
  window.ray_from_window[2] = forward - (half_width * right + half_height * down) / pixels_per_unit;
  const std::array<glm::dvec2, 4> corners{glm::dvec2(0.0, 0.0), glm::dvec2(width, 0.0),
                                          glm::dvec2(width, height), glm::dvec2(0.0, height)};
  for (std::size_t i = 0; i < 4; ++i) {
    window.near_rectangle[i] = world_point(window, corners[i].x, corners[i].y, 0.0);
  }
  return window;
}

glm::dvec3 world_point(const Window& window, double x, double y, double z) {
  // Not by world_from_window, whose terms are the eye over the near plane's distance: far from
  // there they cancel, and the point leaves its ray by their rounding.
  return window.eye + view_distance(window, z) * (window.ray_from_window * glm::dvec3(x, y, 1.0));
}

glm::dvec3 forward(const Window& window) {
  const auto& near = window.near_rectangle;
  return glm::normalize(0.5 * (near[0] + near[2]) - window.eye);
}

double view_distance(const Window& window, double z) {
  return 1.0 / (window.world_from_window[2].w * z + window.world_from_window[3].w);
}

double window_depth(const Window& window, double view_distance) {
  return (1.0 / view_distance - window.world_from_window[3].w) / window.world_from_window[2].w;
}

glm::dmat4 from_window(const Window& window, const glm::dmat3& axes, const glm::dvec3& eye) {
  const glm::dmat3 rays = axes * window.ray_from_window;
  const double per_z = window.world_from_window[2].w;
  const double at_zero = window.world_from_window[3].w;
  return {glm::dvec4(rays[0], 0.0), glm::dvec4(rays[1], 0.0), glm::dvec4(per_z * eye, per_z),
          glm::dvec4(rays[2] + at_zero * eye, at_zero)};
}

glm::dvec4 window_plane(const Window& window, const glm::dvec4& world_plane) {
  const glm::dvec3 normal(world_plane);
  const glm::dvec3 along_rays = normal * window.ray_from_window;
  const double at_eye = glm::dot(normal, window.eye) + world_plane.w;
  const double per_z = window.world_from_window[2].w;
  const double at_zero = window.world_from_window[3].w;
  return {along_rays.x, along_rays.y, at_eye * per_z, along_rays.z + at_eye * at_zero};
}

}  // namespace wedgesim::functional
