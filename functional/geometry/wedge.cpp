#include "functional/geometry/wedge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "functional/geometry/hull.h"
#include "functional/raster/exact_cross.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// A ray on the outline of the penumbra: from one end of the edge, away from the light.
struct OutlineRay {
  std::size_t apex = 0;  // 0 begin, 1 end
  glm::dvec3 direction{0.0};
  glm::dvec3 side{0.0};  // inward normal of the side from this ray to the next; 0 bounds nothing
};

// Directions nearer than this are taken as one: a plane through both is mostly rounding.
constexpr double kLeastSpread = 1e-6;
// An edge that the light's centre sees under less than this points at it.
constexpr double kLeastSine = 1e-14;

constexpr std::uint32_t kNoPlane = 0xffffffffU;

using Edge = std::array<glm::dvec3, 2>;

// The inward normal of the side through two neighbouring rays of a rectangle's outline, or 0 if it
// would be mostly rounding: the edge points at the corner. From the edge and the light's sides
// themselves, not from the rays, which are nearly equal where the light is small. Two neighbours
// differ in the end they pass or in the corner they come from; if in both, a side of the light lies
// along the edge, and its plane holds all four.
glm::dvec3 rectangle_side(const Edge& edge, std::size_t from_end, std::size_t to_end,
                          const glm::dvec3& corner, const glm::dvec3& to_next_corner) {
  const glm::dvec3 ray = edge[from_end] - corner;
  if (to_next_corner != glm::dvec3(0.0)) return glm::cross(to_next_corner, ray);
  const glm::dvec3 along = edge[to_end] - edge[from_end];
  const glm::dvec3 side = glm::cross(ray, along);
  const bool clear = glm::length(side) >= kLeastSpread * glm::length(ray) * glm::length(along);
  return clear ? side : glm::dvec3(0.0);
}

// Rays through the edge's ends from the corners of the rectangle: the hull of their directions, in
// order around the axis of the light, counter-clockwise about its normal.
std::vector<OutlineRay> rectangle_outline(const Light& light, const Edge& edge) {
  const glm::dvec3 u = glm::normalize(light.half_u);
  const glm::dvec3 v = glm::normalize(light.half_v);
  const glm::dvec3 normal = glm::cross(u, v);
  const auto across = [&](const glm::dvec3& d) {
    return glm::dvec2(glm::dot(d, u), glm::dot(d, v));
  };
  const glm::dvec3 to_begin = edge[0] - light.centre;
  const glm::dvec3 along = edge[1] - edge[0];
  const std::array<double, 2> height{glm::dot(to_begin, normal),
                                     glm::dot(edge[1] - light.centre, normal)};
  // Slopes less that of the ray from the centre through the edge's begin: small lights and short
  // edges keep their digits.
  const glm::dvec2 end_slope =
      (across(along) * height[0] - across(to_begin) * glm::dot(along, normal)) /
      (height[0] * height[1]);
  constexpr std::array<glm::dvec2, 4> kCorners{glm::dvec2(-1, -1), {1, -1}, {1, 1}, {-1, 1}};
  std::vector<glm::dvec2> slopes;
  for (std::size_t apex = 0; apex < 2; ++apex) {
    for (const glm::dvec2& corner : kCorners) {
      const glm::dvec2 offset(corner.x * glm::length(light.half_u),
                              corner.y * glm::length(light.half_v));
      slopes.push_back((apex == 0 ? glm::dvec2(0.0) : end_slope) - offset / height[apex]);
    }
  }
  const std::vector<std::size_t> hull = convex_hull_indices(slopes);
  std::vector<OutlineRay> outline;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const std::size_t apex = hull[i] / 4;
    const std::size_t next = hull[(i + 1) % hull.size()];
    const glm::dvec2 corner = kCorners[hull[i] % 4];
    glm::dvec2 way = kCorners[next % 4] - corner;
    // Slopes go against corners; only between two ends on one line with both can they go along.
    if (glm::dot(way, slopes[next] - slopes[hull[i]]) > 0.0) way = -way;
    const glm::dvec3 from = light.centre + corner.x * light.half_u + corner.y * light.half_v;
    outline.push_back(
        {apex, (edge[apex] - from) / height[apex],
         rectangle_side(edge, apex, next / 4, from, way.x * light.half_u + way.y * light.half_v)});
  }
  return outline;
}

// Unit normals of planes that touch the sphere and the edge, into the penumbra, counter-clockwise
// about the way of the light. The normals n with n·(e − c) ≥ r form a cap about the direction to e;
// those that serve both ends lie in the intersection of two caps, whose corners are the planes
// through the whole edge.
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
  const glm::dvec3 along = edge[1] - edge[0];
  // Between the ends of a short edge, or of a long one in a line with the centre, little is left.
  const glm::dvec3 w =
      exact_cross({edge[0], light.centre}, {edge[1], light.centre}) / (distance[0] * distance[1]);
  const double sin_between = glm::length(w);
  const double cos_between = glm::dot(axis[0], axis[1]);
  const double farther = glm::dot(along, a[0] + a[1]) / (distance[0] + distance[1]);  // end 1, by

  // Corner of the caps: cos φ of the angle about axis 0 away from the direction to axis 1.
  const auto corner_cosine = [&](std::size_t i) {
    const double nearer_cone = (i == 0 ? -farther : farther) / distance[1 - i];
    const double bend =
        cos_between > 0.0 ? sin_between * sin_between / (1.0 + cos_between) : 1.0 - cos_between;
    return cosine[i] * (nearer_cone + bend) / (sine[i] * sin_between);
  };
  const bool lens = sin_between > kLeastSine && std::abs(corner_cosine(0)) < 1.0 - 1e-9 &&
                    std::abs(corner_cosine(1)) < 1.0 - 1e-9;
  std::vector<SphereNormal> normals;
  if (!lens) {
    // One cone holds the other, or nearly so: a pyramid about the cone of the nearer end, opened
    // until it holds both.
    const std::size_t i = distance[0] <= distance[1] ? 0 : 1;
    const double between = std::atan2(sin_between, cos_between);
    const double excess = std::acos(cosine[i]) + between - std::acos(cosine[1 - i]);
    const double cap = std::acos(cosine[i]) - std::max(excess, 0.0);
    const auto [p, q] = Across(axis[i]);
    for (int k = 0; k < 6; ++k) {
      const double angle = 2.0 * M_PI * k / 6.0;
      normals.push_back(
          {std::cos(cap) * axis[i] + std::sin(cap) * (std::cos(angle) * p + std::sin(angle) * q),
           i == 0, i == 1});
    }
    return normals;
  }
  const glm::dvec3 side = w / sin_between;
  // Around axis i, from one corner of the caps towards the other: the corner it starts from and two
  // normals between them.
  const auto arc = [&](std::size_t i, double from, double to) {
    const glm::dvec3 way = i == 0 ? along : -along;
    const glm::dvec3 towards = glm::normalize(way - glm::dot(way, axis[i]) * axis[i]);
    const double half = std::acos(corner_cosine(i));
    for (int k = 0; k < 3; ++k) {
      const double angle = half * (from + (to - from) * k / 3.0);
      const bool corner = k == 0;
      normals.push_back(
          {cosine[i] * axis[i] + sine[i] * (std::cos(angle) * towards + std::sin(angle) * side),
           corner || i == 0, corner || i == 1});
    }
  };
  arc(0, -1.0, 1.0);
  arc(1, 1.0, -1.0);
  return normals;
}

std::vector<OutlineRay> sphere_outline(const Light& light, const Edge& edge) {
  const std::vector<SphereNormal> normals = sphere_normals(light, edge);
  std::vector<OutlineRay> rays;
  for (std::size_t k = 0; k < normals.size(); ++k) {
    const SphereNormal& a = normals[k];
    const SphereNormal& b = normals[(k + 1) % normals.size()];
    const bool share_begin = a.at_begin && b.at_begin;
    rays.push_back(
        {share_begin ? 0U : 1U, glm::normalize(glm::cross(a.normal, b.normal)), b.normal});
  }
  return rays;
}

// Leaves as many sides as a wedge can hold, without those most parallel to their neighbours: more
// come from rounding alone, and fewer planes bound more.
void drop_surplus_sides(std::vector<OutlineRay>& rays) {
  for (;;) {
    std::vector<OutlineRay*> sides;
    for (OutlineRay& ray : rays) {
      if (ray.side != glm::dvec3(0.0)) sides.push_back(&ray);
    }
    if (sides.size() < kMaxPlanes) return;
    OutlineRay* surplus = nullptr;
    double least_turn = 2.0;
    for (std::size_t i = 0; i < sides.size(); ++i) {
      const double turn = glm::length(glm::cross(
          glm::normalize(sides[i]->side), glm::normalize(sides[(i + 1) % sides.size()]->side)));
      if (turn < least_turn) {
        least_turn = turn;
        surplus = sides[i];
      }
    }
    surplus->side = glm::dvec3(0.0);
  }
}

}  // namespace

glm::dvec4 quad_plane(const glm::dvec3& light_centre, const glm::dvec3& begin,
                      const glm::dvec3& end) {
  const glm::dvec3 normal = exact_cross({end, light_centre}, {begin, light_centre});
  return {normal, -glm::dot(normal, light_centre)};
}

WorldWedge coverage_wedge(const Light& light, const glm::dvec3& begin, const glm::dvec3& end,
                          const EndPlane& end_plane) {
  const Edge edge{begin, end};
  std::vector<OutlineRay> rays = light.shape == LightShape::rectangle
                                     ? rectangle_outline(light, edge)
                                     : sphere_outline(light, edge);
  drop_surplus_sides(rays);
  WorldWedge wedge;
  const std::size_t n = rays.size();
  std::vector<std::uint32_t> plane_of(n, kNoPlane);  // of the side after each ray
  for (std::size_t i = 0; i < n; ++i) {
    if (rays[i].side == glm::dvec3(0.0)) continue;
    const glm::dvec3 unit = glm::normalize(rays[i].side);
    plane_of[i] = static_cast<std::uint32_t>(wedge.planes.size());
    wedge.planes.emplace_back(unit, -std::min(glm::dot(unit, begin), glm::dot(unit, end)));
  }
  if (wedge.planes.size() < 3) return {};
  // A side without a plane of its own is next to rounding: it takes the next one's.
  for (std::size_t i = 2 * n; i-- > 0;) {
    if (plane_of[i % n] == kNoPlane) plane_of[i % n] = plane_of[(i + 1) % n];
  }

  wedge.vertices = {begin, end};
  for (const OutlineRay& ray : rays) {
    wedge.vertices.push_back(end_plane.reach(edge[ray.apex] - ray.direction, edge[ray.apex]));
  }
  WedgeFace bottom;
  bottom.plane = static_cast<std::uint32_t>(wedge.planes.size());
  wedge.planes.push_back(end_plane.plane);
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const auto apex_from = static_cast<std::uint32_t>(rays[i].apex);
    const auto apex_to = static_cast<std::uint32_t>(rays[j].apex);
    const auto base_from = static_cast<std::uint32_t>(2 + i);
    const auto base_to = static_cast<std::uint32_t>(2 + j);
    WedgeFace face{plane_of[i], {apex_to, base_to, base_from, apex_from}};
    if (apex_to == apex_from) face.corners.pop_back();
    wedge.faces.push_back(std::move(face));
    bottom.corners.push_back(base_from);
  }
  wedge.faces.push_back(std::move(bottom));
  return wedge;
}

std::vector<std::vector<glm::dvec3>> faces_inside(const WorldWedge& wedge,
                                                  const glm::dvec4& plane) {
  const auto value = [&](const glm::dvec3& p) { return glm::dot(plane, glm::dvec4(p, 1.0)); };
  std::vector<std::vector<glm::dvec3>> faces;
  for (const WedgeFace& face : wedge.faces) {
    std::vector<glm::dvec3> part;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const glm::dvec3& a = wedge.vertices[face.corners[i]];
      const glm::dvec3& b = wedge.vertices[face.corners[(i + 1) % face.corners.size()]];
      const double at_a = value(a);
      const double at_b = value(b);
      if (at_a >= 0.0) part.push_back(a);
      if ((at_a >= 0.0) != (at_b >= 0.0)) part.push_back(a + at_a / (at_a - at_b) * (b - a));
    }
    if (part.size() >= 3) faces.push_back(std::move(part));
  }
  return faces;
}

}  // namespace wedgesim::functional
