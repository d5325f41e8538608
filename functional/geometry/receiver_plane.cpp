#include "functional/geometry/receiver_plane.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "base/error.h"
#include "functional/geometry/extent.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {

glm::dvec3 ReceiverPlane::from_world(const glm::dvec3& p) const {
  const glm::dvec3 way = p - origin;
  return {glm::dot(way, x_axis), glm::dot(way, y_axis), glm::dot(way, normal)};
}

glm::dvec3 ReceiverPlane::to_world(const glm::dvec2& p) const {
  return origin + p.x * x_axis + p.y * y_axis;
}

GridPoint ReceiverPlane::vertex(const glm::dvec2& p) const {
  const auto round = [&](double value) {
    const double half = std::round(value / (2.0 * unit));
    CHECK_LE(std::abs(half), kGridLimit / 2);
    return 2 * static_cast<std::int32_t>(half);
  };
  return {round(p.x), round(p.y)};
}

bool ReceiverPlane::locate(const glm::dvec2& p, GridPoint& point) const {
  const double x = p.x / unit;
  const double y = p.y / unit;
  if (!(std::abs(x) < kGridLimit && std::abs(y) < kGridLimit)) return false;
  // std::floor and std::round are calls without SSE 4.1; what is cut off here is above 0.
  const auto round = [](double value) {
    return static_cast<std::int32_t>(value + (kGridLimit + 0.5)) - kGridLimit;
  };
  point = {round(x), round(y)};
  return true;
}

ReceiverPlane find_receiver_plane(const Scene& scene) {
  // The plane of the largest triangle.
  glm::dvec3 largest(0.0);
  Bounds bounds;
  ReceiverPlane plane;
  for (const Object& object : scene.objects) {
    if (object.casts) continue;
    for (const auto& t : object.mesh.triangles) {
      const auto& p = object.mesh.positions;
      const glm::dvec3 area = glm::cross(p[t[1]] - p[t[0]], p[t[2]] - p[t[0]]);
      if (glm::dot(area, area) > glm::dot(largest, largest)) {
        largest = area;
        plane.origin = p[t[0]];
      }
      for (const std::uint32_t v : t) bounds.grow(p[v]);
    }
  }
  constexpr const char* kExpected = "receivers in one plane, on which rings can be drawn";
  if (largest == glm::dvec3(0.0)) throw InputError(scene.place, "nothing receives", kExpected);
  plane.normal = glm::normalize(largest);
  if (glm::dot(plane.normal, scene.light.centre - plane.origin) < 0.0) {
    plane.normal = -plane.normal;
  }
  for (const Object& object : scene.objects) {
    if (object.casts) continue;
    for (const auto& t : object.mesh.triangles) {
      for (const std::uint32_t v : t) {
        const double height = glm::dot(plane.normal, object.mesh.positions[v] - plane.origin);
        if (std::abs(height) <= kPlaneTolerance * bounds.diagonal()) continue;
        throw InputError(scene.place,
                         fmt::format("'{}' is {:.3g} off the plane of the other receivers",
                                     object.mesh.name, std::abs(height)),
                         kExpected);
      }
    }
  }
  const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
  plane.origin = centre - glm::dot(plane.normal, centre - plane.origin) * plane.normal;
  const auto [x_axis, y_axis] = Across(plane.normal);
  plane.x_axis = x_axis;
  plane.y_axis = y_axis;
  return plane;
}

}  // namespace wedgesim::functional
