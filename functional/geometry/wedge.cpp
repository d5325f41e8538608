#include "functional/geometry/wedge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "functional/geometry/hull.h"

namespace wedgesim::functional {
namespace {

// A ray on the outline of the penumbra: from one end of the edge, away from the light.
struct OutlineRay {
  std::size_t apex = 0;  // 0 begin, 1 end
  glm::dvec3 direction{0.0};
};

using Edge = std::array<glm::dvec3, 2>;

// Rays through the edge's ends from the corners of the rectangle: the hull of their directions, in
// order around the axis of the light, counter-clockwise about its normal.
std::vector<OutlineRay> rectangle_outline(const Light& light, const Edge& edge) {
  const glm::dvec3 u = glm::normalize(light.half_u);
  const glm::dvec3 v = glm::normalize(light.half_v);
  const glm::dvec3 normal = glm::cross(u, v);
  std::vector<OutlineRay> rays;
  std::vector<glm::dvec2> slopes;
  for (std::size_t apex = 0; apex < 2; ++apex) {
    for (const glm::dvec3& corner : light_corners(light)) {
      const glm::dvec3 d = edge[apex] - corner;
      const double height = glm::dot(d, normal);
      rays.push_back({apex, d / height});
      slopes.push_back(glm::dvec2(glm::dot(d, u), glm::dot(d, v)) / height);
    }
  }
  std::vector<OutlineRay> outline;
  for (const std::size_t i : convex_hull_indices(slopes)) outline.push_back(rays[i]);
  return outline;
}

// Unit normals of planes that touch the sphere and the edge, in order around the edge. The normals
// n with n·(e − c) ≥ r form a cap about the direction to e; those that serve both ends lie in the
// intersection of two caps, whose corners are the planes through the whole edge.
struct SphereNormal {
  glm::dvec3 normal;
  bool at_begin, at_end;  // which ends its plane passes through
};

std::vector<SphereNormal> sphere_normals(const Light& light, const Edge& edge) {
  const std::array<glm::dvec3, 2> a{edge[0] - light.centre, edge[1] - light.centre};
  const std::array<double, 2> distance{glm::length(a[0]), glm::length(a[1])};
  const std::array<glm::dvec3, 2> axis{a[0] / distance[0], a[1] / distance[1]};
  std::array<double, 2> cosine{};
  std::array<double, 2> sine{};
  for (std::size_t i = 0; i < 2; ++i) {
    cosine[i] = std::min(1.0, light.radius / distance[i]);
    sine[i] = std::sqrt(1.0 - cosine[i] * cosine[i]);
  }
  const glm::dvec3 w = glm::cross(axis[0], axis[1]);
  const double sin_between = glm::length(w);
  const double cos_between = glm::dot(axis[0], axis[1]);

  // Corner of the caps: cos φ of the angle about axis 0 away from the direction to axis 1.
  const auto corner_cosine = [&](std::size_t i) {
    return (cosine[1 - i] - cosine[i] * cos_between) / (sine[i] * sin_between);
  };
  const bool lens = sin_between > 1e-12 && std::abs(corner_cosine(0)) < 1.0 - 1e-9 &&
                    std::abs(corner_cosine(1)) < 1.0 - 1e-9;
  std::vector<SphereNormal> normals;
  if (!lens) {
    // One cone holds the other: a pyramid about the cone of the nearer end.
    const std::size_t i = distance[0] <= distance[1] ? 0 : 1;
    const glm::dvec3 helper = std::abs(axis[i].x) < 0.6 ? glm::dvec3(1, 0, 0) : glm::dvec3(0, 1, 0);
    const glm::dvec3 p = glm::normalize(glm::cross(axis[i], helper));
    const glm::dvec3 q = glm::cross(axis[i], p);
    for (int k = 0; k < 6; ++k) {
      const double angle = 2.0 * M_PI * k / 6.0;
      normals.push_back(
          {cosine[i] * axis[i] + sine[i] * (std::cos(angle) * p + std::sin(angle) * q), i == 0,
           i == 1});
    }
    return normals;
  }
  const glm::dvec3 side = w / sin_between;
  // Around axis i, from the corner on `side` by the arc to the other corner: both corners and two
  // normals between them for each arc.
  const auto arc = [&](std::size_t i, double from, double to) {
    const glm::dvec3 towards = glm::normalize(axis[1 - i] - cos_between * axis[i]);
    const double half = std::acos(corner_cosine(i));
    for (int k = 0; k < 3; ++k) {
      const double angle = half * (from + (to - from) * k / 3.0);
      const bool corner = k == 0;
      normals.push_back(
          {cosine[i] * axis[i] + sine[i] * (std::cos(angle) * towards + std::sin(angle) * side),
           corner || i == 0, corner || i == 1});
    }
  };
  arc(0, 1.0, -1.0);
  arc(1, -1.0, 1.0);
  return normals;
}

std::vector<OutlineRay> sphere_outline(const Light& light, const Edge& edge) {
  const std::vector<SphereNormal> normals = sphere_normals(light, edge);
  const glm::dvec3 away = glm::normalize(0.5 * (edge[0] + edge[1]) - light.centre);
  std::vector<OutlineRay> rays;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const SphereNormal& a = normals[k];
    const SphereNormal& b = normals[(k + 1) % normals.size()];
    glm::dvec3 direction = glm::cross(a.normal, b.normal);
    if (glm::dot(direction, away) < 0.0) direction = -direction;
    const bool share_begin = a.at_begin && b.at_begin;
    rays.push_back({share_begin ? 0U : 1U, glm::normalize(direction)});
  }
  return rays;
}

}  // namespace

glm::dvec4 quad_plane(const glm::dvec3& light_centre, const glm::dvec3& begin,
                      const glm::dvec3& end) {
  const glm::dvec3 normal = glm::cross(end - light_centre, begin - light_centre);
  return {normal, -glm::dot(normal, light_centre)};
}

WorldWedge coverage_wedge(const Light& light, const glm::dvec3& begin, const glm::dvec3& end,
                          const EndPlane& end_plane) {
  const Edge edge{begin, end};
  std::vector<OutlineRay> rays = light.shape == LightShape::rectangle
                                     ? rectangle_outline(light, edge)
                                     : sphere_outline(light, edge);
  WorldWedge wedge;
  if (rays.size() < 3) return wedge;
  const std::size_t n = rays.size();

  wedge.vertices = {begin, end};
  for (const OutlineRay& ray : rays) {
    wedge.vertices.push_back(end_plane.reach(edge[ray.apex] - ray.direction, edge[ray.apex]));
  }
  const glm::dvec3 away = 0.5 * (begin + end) - light.centre;
  glm::dvec3 turn(0.0);
  for (std::size_t i = 0; i < n; ++i) {
    turn += glm::cross(rays[i].direction, rays[(i + 1) % n].direction);
  }
  // Counter-clockwise about the way of the light: then d_i × d_{i+1} points inwards.
  const bool reversed = glm::dot(turn, away) < 0.0;
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const std::size_t from = reversed ? j : i;
    const std::size_t to = reversed ? i : j;
    const glm::dvec3 normal = glm::cross(rays[from].direction, rays[to].direction);
    const double length = glm::length(normal);
    if (length == 0.0) continue;
    const glm::dvec3 unit = normal / length;
    const double offset = -std::min(glm::dot(unit, begin), glm::dot(unit, end));
    WedgeFace face;
    face.plane = static_cast<std::uint32_t>(wedge.planes.size());
    wedge.planes.emplace_back(unit, offset);
    const auto apex_from = static_cast<std::uint32_t>(rays[from].apex);
    const auto apex_to = static_cast<std::uint32_t>(rays[to].apex);
    const auto base_from = static_cast<std::uint32_t>(2 + from);
    const auto base_to = static_cast<std::uint32_t>(2 + to);
    face.corners = {apex_to, base_to, base_from, apex_from};
    if (apex_to == apex_from) face.corners.pop_back();
    wedge.faces.push_back(std::move(face));
  }
  WedgeFace bottom;
  bottom.plane = static_cast<std::uint32_t>(wedge.planes.size());
  wedge.planes.push_back(end_plane.plane);
  for (std::size_t i = 0; i < n; ++i) {
    bottom.corners.push_back(static_cast<std::uint32_t>(2 + (reversed ? n - 1 - i : i)));
  }
  wedge.faces.push_back(std::move(bottom));
  // More sides than the format holds can come from rounding alone: fewer planes bound more.
  while (wedge.planes.size() > kMaxPlanes) {
    wedge.planes.erase(wedge.planes.end() - 2);
    for (WedgeFace& face : wedge.faces) {
      face.plane = std::min(face.plane, static_cast<std::uint32_t>(wedge.planes.size() - 1));
    }
  }
  return wedge;
}

}  // namespace wedgesim::functional
