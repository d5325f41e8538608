#include "functional/scene/scene_check.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <glm/vector_relational.hpp>
#include <vector>

#include "base/error.h"
#include "base/toml_table.h"
#include "functional/scene/lights.h"
#include "functional/scene/manifold.h"
#include "functional/scene/transform.h"

namespace wedgesim::functional {
namespace {

using Triangle = std::array<glm::dvec3, 3>;

Triangle corners(const Mesh& mesh, const std::array<std::uint32_t, 3>& t) {
  return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]};
}

void check_mesh(const Mesh& mesh, const std::string& place) {
  if (mesh.triangles.empty()) {
    throw InputError(place, fmt::format("mesh '{}' is empty", mesh.name), "at least one triangle");
  }
  for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
    const glm::dvec3& p = mesh.positions[i];
    const auto fits = [](double coordinate) { return std::abs(coordinate) <= Range::kLargest; };
    if (fits(p.x) && fits(p.y) && fits(p.z)) continue;
    throw InputError(
        place,
        fmt::format("mesh '{}': vertex {} is at ({:g}, {:g}, {:g})", mesh.name, i, p.x, p.y, p.z),
        fmt::format("numbers from {:g} to {:g}", -Range::kLargest, Range::kLargest));
  }
}

/// How often a closed mesh winds round a point: the sum of its triangles' solid angles.
double winding_number(const Mesh& mesh, glm::dvec3 point) {
  double sum = 0.0;
  for (const auto& t : mesh.triangles) {
    const auto [pa, pb, pc] = corners(mesh, t);
    const glm::dvec3 a = pa - point;
    const glm::dvec3 b = pb - point;
    const glm::dvec3 c = pc - point;
    const double la = glm::length(a);
    const double lb = glm::length(b);
    const double lc = glm::length(c);
    sum += std::atan2(glm::dot(a, glm::cross(b, c)), la * lb * lc + glm::dot(a, b) * lc +
                                                         glm::dot(b, c) * la + glm::dot(c, a) * lb);
  }
  return sum / glm::two_pi<double>();
}

glm::dvec3 closest_on_segment(glm::dvec3 a, glm::dvec3 b, glm::dvec3 point) {
  const glm::dvec3 along = b - a;
  const double length2 = glm::dot(along, along);
  const double t = length2 > 0.0 ? glm::dot(point - a, along) / length2 : 0.0;
  return a + std::clamp(t, 0.0, 1.0) * along;
}

double distance_to(const Triangle& triangle, glm::dvec3 point) {
  const auto& [a, b, c] = triangle;
  const glm::dvec3 normal = glm::cross(b - a, c - a);
  const double length = glm::length(normal);
  const auto inner = [&](glm::dvec3 from, glm::dvec3 to) {
    return glm::dot(glm::cross(to - from, point - from), normal) >= 0.0;
  };
  if (length > 0.0 && inner(a, b) && inner(b, c) && inner(c, a)) {
    return std::abs(glm::dot(point - a, normal)) / length;
  }
  return std::min({glm::distance(point, closest_on_segment(a, b, point)),
                   glm::distance(point, closest_on_segment(b, c, point)),
                   glm::distance(point, closest_on_segment(c, a, point))});
}

/// The part of a polygon where dot(point, normal) <= limit.
std::vector<glm::dvec3> clipped(const std::vector<glm::dvec3>& polygon, glm::dvec3 normal,
                                double limit) {
  std::vector<glm::dvec3> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec3 from = polygon[i];
    const glm::dvec3 to = polygon[(i + 1) % polygon.size()];
    const double out_from = glm::dot(from, normal) - limit;
    const double out_to = glm::dot(to, normal) - limit;
    if (out_from <= 0.0) {
      kept.push_back(from);
    }
    if ((out_from < 0.0 && out_to > 0.0) || (out_from > 0.0 && out_to < 0.0)) {
      kept.push_back(from + (out_from / (out_from - out_to)) * (to - from));
    }
  }
  return kept;
}

/// A triangle touches a rectangle if what is left of it over the rectangle's sides reaches the
/// plane from both sides.
bool touches_rectangle(const Triangle& triangle, const Light& light) {
  std::vector<glm::dvec3> polygon(triangle.begin(), triangle.end());
  for (const glm::dvec3& half : {light.half_u, -light.half_u, light.half_v, -light.half_v}) {
    polygon = clipped(polygon, half, glm::dot(half, light.centre) + glm::dot(half, half));
  }
  const glm::dvec3 normal = glm::cross(light.half_u, light.half_v);
  bool above = false;
  bool below = false;
  for (const glm::dvec3& p : polygon) {
    const double height = glm::dot(p - light.centre, normal);
    above = above || height >= 0.0;
    below = below || height <= 0.0;
  }
  return above && below;
}

bool touches(const Triangle& triangle, const Light& light) {
  if (light.shape == LightShape::rectangle && light.half_u != glm::dvec3(0.0) &&
      light.half_v != glm::dvec3(0.0)) {
    return touches_rectangle(triangle, light);
  }
  const double reach = light.shape == LightShape::sphere ? light.radius : 0.0;
  return distance_to(triangle, light.centre) <= reach;
}

void check_light(const Object& object, const Light& light, const std::string& place) {
  const Mesh& mesh = object.mesh;
  const glm::dvec3 normal = glm::cross(light.half_u, light.half_v);
  const bool has_plane =
      light.shape == LightShape::rectangle && glm::dot(normal, normal) > 0.0 && object.casts;
  for (const auto& t : mesh.triangles) {
    const Triangle triangle = corners(mesh, t);
    if (touches(triangle, light)) {
      throw InputError(place, fmt::format("the light touches '{}'", mesh.name),
                       "a light clear of all geometry");
    }
    for (const glm::dvec3& p : triangle) {
      if (has_plane && !(glm::dot(p - light.centre, normal) > 0.0)) {
        throw InputError(place,
                         fmt::format("caster '{}' is not in front of the light: ({:g}, {:g}, {:g})",
                                     mesh.name, p.x, p.y, p.z),
                         "casters strictly in front of the light's plane");
      }
    }
  }
  const auto [low, high] = bounds_of(mesh);
  const bool near =
      glm::all(glm::lessThan(low, light.centre)) && glm::all(glm::lessThan(light.centre, high));
  if (near && examine(mesh).closed() && std::abs(winding_number(mesh, light.centre)) > 0.5) {
    throw InputError(place, fmt::format("the light is inside '{}'", mesh.name),
                     "a light clear of all geometry");
  }
}

}  // namespace

void check_scene(const Scene& scene, const std::string& place) {
  if (scene.objects.empty()) {
    throw InputError(place, "the scene has no objects", "at least one [[object]]");
  }
  for (const Object& object : scene.objects) {
    check_mesh(object.mesh, place);
    for (std::size_t i = 0; i < light_count(scene); ++i) {
      check_light(object, light_at(scene, i), place);
    }
  }
}

}  // namespace wedgesim::functional
