#include "functional/geometry/loose_wedge.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr double kLeastSine = 1e-6;  // an edge seen under less points at the light

double radius_around(const Light& light) {
  return light.shape == LightShape::rectangle ? glm::length(light.half_u + light.half_v)
                                              : light.radius;
}

}  // namespace

std::optional<WorldWedge> loose_wedge(const Light& light, const glm::dvec3& begin,
                                      const glm::dvec3& end, const EndPlane& end_plane) {
  const double radius = radius_around(light);
  const glm::dvec3 to_begin = glm::normalize(begin - light.centre);
  const glm::dvec3 to_end = glm::normalize(end - light.centre);
  const double distance =
      std::min(glm::distance(begin, light.centre), glm::distance(end, light.centre));
  const glm::dvec3 across = to_end - to_begin;
  if (distance <= radius || glm::length(across) < kLeastSine) return std::nullopt;
  const std::array<glm::dvec3, 2> edge{light.centre + distance * to_begin,
                                       light.centre + distance * to_end};
  const glm::dvec3 along = glm::normalize(across);
  const glm::dvec3 out = glm::normalize(to_begin + to_end);
  const double middle_distance = distance * glm::dot(out, to_begin);
  if (middle_distance <= radius) return std::nullopt;
  // A plane at a sine of radius to distance from the way of the light touches the sphere.
  const auto tilted = [](const glm::dvec3& aside, const glm::dvec3& away, double sine) {
    return std::sqrt(1.0 - sine * sine) * aside + sine * away;
  };
  const glm::dvec3 normal = glm::cross(along, out);
  const double edge_sine = radius / middle_distance;
  const double end_sine = radius / distance;
  const auto inward = [&](std::size_t i) {
    const glm::dvec3& away = i == 0 ? to_begin : to_end;
    const glm::dvec3 way = i == 0 ? along : -along;
    return tilted(glm::normalize(way - glm::dot(way, away) * away), away, end_sine);
  };
  // Counter-clockwise as seen along the light: front, end, back, begin.
  const std::array<glm::dvec3, 4> sides{tilted(-normal, out, edge_sine), inward(1),
                                        tilted(normal, out, edge_sine), inward(0)};
  constexpr std::array<std::size_t, 4> kApex{1, 1, 0, 0};  // of the ray between a side and the next
  WorldWedge wedge;
  wedge.vertices = {edge[0], edge[1]};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3& apex = edge[kApex[i]];
    wedge.planes.emplace_back(sides[i], -glm::dot(sides[i], i == 3 ? edge[0] : edge[1]));
    glm::dvec3 ray = glm::cross(sides[i], sides[(i + 1) % 4]);
    if (glm::dot(ray, out) < 0.0) ray = -ray;
    if (!(glm::dot(glm::dvec3(end_plane.plane), ray) < -kLeastSine * glm::length(ray))) {
      return std::nullopt;
    }
    wedge.vertices.push_back(end_plane.reach(apex - ray, apex));
  }
  wedge.planes.push_back(end_plane.plane);
  // Rays 2…5: after front, end, back and begin.
  wedge.faces = {
      {0, {0, 5, 2, 1}}, {1, {1, 2, 3}}, {2, {1, 3, 4, 0}}, {3, {0, 4, 5}}, {4, {2, 5, 4, 3}}};
  return wedge;
}

}  // namespace wedgesim::functional
