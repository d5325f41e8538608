#pragma once

#include <array>
#include <glm/mat3x3.hpp>
#include <glm/mat4x4.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A frame seen through a camera. Window space: x right, y down, pixel centres at +0.5, depth in
/// [0, 1], 0 near; its homogeneous w is the distance along the view direction, world units.
struct Window {
  int width = 0;
  int height = 0;
  glm::dmat4 window_from_world{1.0};
  glm::dmat4 world_from_window{1.0};  // (x, y, z, 1) gives homogeneous world, w > 0
  glm::dvec3 eye{0.0};
  glm::dmat3 ray_from_window{1.0};  // (x, y, 1) gives the world's way from the eye at distance 1
  std::array<glm::dvec3, 4> near_rectangle{};  // world space, in order around it
};

/// \throws InputError if the camera looks nowhere or its near and far planes are not in order
Window make_window(const Camera& camera, int width, int height);

/// The world point at a window position: rounded by half a unit of its coordinates, and along the
/// ray by what the depth's distance from 1 is.
/// \param x, y  pixels; \param z window depth, [0, 1]
glm::dvec3 world_point(const Window& window, double x, double y, double z);

/// Unit vector along the view direction.
glm::dvec3 forward(const Window& window);

/// Distance along the view direction, world units, of a window depth in [0, 1]; and back: any
/// distance above 0 gives a depth below 1.
double view_distance(const Window& window, double z);
double window_depth(const Window& window, double view_distance);

/// The homogeneous matrix from the window to a space whose axes are linear in the world's: by the
/// eye's place there, so that both terms of z have its digits.
/// \param axes  the space's vectors from the world's
/// \param eye   in that space
glm::dmat4 from_window(const Window& window, const glm::dmat3& axes, const glm::dvec3& eye);

/// A world plane (n, d), n·p + d, as window plane coefficients: the value at (x, y, z, 1) is the
/// world value divided by clip w, so its sign and ratios of such values are kept. Of a plane near
/// the eye z and the constant cancel; both have the digits of its value at the eye.
glm::dvec4 window_plane(const Window& window, const glm::dvec4& world_plane);

}  // namespace wedgesim::functional
