#include "functional/raster/light_window.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

constexpr double kMostTangent = 12.0;  // of half the angle of view: 85 degrees

// What a view along an axis holds, in tangents from the axis.
struct Sight {
  glm::dvec2 low{1e300}, high{-1e300};
  double near = 1e300;
  double reach = 0.0;  // of casters and penumbrae
};

Sight look(std::span<const Object> objects, const glm::dvec3& centre, double radius, double far,
           const glm::dvec3& axis) {
  const Across across(axis);
  Sight sight;
  for (const Object& object : objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      const glm::dvec3 way = p - centre;
      const double z = glm::dot(way, axis);
      sight.near = std::min(sight.near, z);
      if (z <= 0.0) continue;
      const glm::dvec2 q = glm::dvec2(glm::dot(way, across.u), glm::dot(way, across.v)) / z;
      sight.low = glm::min(sight.low, q);
      sight.high = glm::max(sight.high, q);
      const double penumbra =
          radius * std::sqrt(1.0 + glm::dot(q, q)) * std::max(0.0, 1.0 / z - 1.0 / far);
      sight.reach = std::max({sight.reach, std::abs(q.x) + penumbra, std::abs(q.y) + penumbra});
    }
  }
  return sight;
}

// Beyond every point of the scene, from the light.
double farthest(std::span<const Object> objects, const glm::dvec3& centre) {
  double far = 0.0;
  for (const Object& object : objects) {
    for (const glm::dvec3& p : object.mesh.positions) {
      far = std::max(far, glm::distance(p, centre));
    }
  }
  return far;
}

glm::dvec3 towards_casters(std::span<const Object> objects, const glm::dvec3& centre) {
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  for (const Object& object : objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const glm::dvec3 way = 0.5 * (low + high) - centre;
  const double length = glm::length(way);
  return length > 0.0 && length < 1e200 ? way / length : glm::dvec3(0.0, -1.0, 0.0);
}

}  // namespace

Window make_light_window(std::span<const Object> objects, const glm::dvec3& centre, double radius,
                         int size) {
  const double far = std::max(farthest(objects, centre), 1e-300);
  glm::dvec3 axis = towards_casters(objects, centre);
  Sight sight = look(objects, centre, radius, far, axis);
  if (sight.near > 0.0 && sight.high.x >= sight.low.x) {
    // Once more along the middle of what is seen, for a narrower view.
    const Across across(axis);
    const glm::dvec2 middle = 0.5 * (sight.low + sight.high);
    axis = glm::normalize(axis + middle.x * across.u + middle.y * across.v);
    sight = look(objects, centre, radius, far, axis);
  }
  if (!(sight.near > 0.0 && sight.reach < kMostTangent)) {
    throw InputError("light", "its casters or their penumbrae span a half-space about it",
                     "casters within 85 degrees of one direction, outside the light");
  }
  Camera camera;
  camera.eye = centre;
  camera.target = centre + axis;
  camera.up = Across(axis).v;
  const double half = std::max(1.01 * sight.reach, 1e-6);
  camera.field_of_view_degrees = glm::degrees(2.0 * std::atan(half));
  camera.near_plane = 0.5 * std::min(sight.near, far);
  camera.far_plane = 2.0 * far;
  return make_window(camera, size, size);
}

double focal_length(const Window& light_window) {
  const glm::dmat4& m = light_window.window_from_world;
  const glm::dvec3 x(m[0][0], m[1][0], m[2][0]);
  const glm::dvec3 w(m[0][3], m[1][3], m[2][3]);
  return glm::length(x - 0.5 * light_window.width * w);
}

}  // namespace wedgesim::functional
