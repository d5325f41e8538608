#include "functional/geometry/linear_wedge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

#include "functional/geometry/linear_corner.h"
#include "functional/geometry/polyhedron.h"
#include "functional/raster/exact_cross.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// An edge whose line passes the light's centre at less than this share of the distance to its
// nearer end has no sensible front and back plane.
constexpr double kPointsAtLight = 1e-3;
// The direction of an edge that is shorter than this share of its way from the light's centre is
// rounding, more than the edge's shadow is long.
constexpr double kShortest = 1e-10;
// Between a front and a back plane that face one another at less than this angle there is nothing.
constexpr double kFlat = 0x1p-50;
// Of a wedge, as thin near its edge as its light is small: parts of the light.
constexpr double kAccuracy = 1e-9;
// How far a wedge whose sides diverge may go, in diagonals of all that receives.
constexpr double kLidRadius = 4.0;

double least_half_size(const Light& light) {
  if (light.shape != LightShape::rectangle) return light.radius;
  return std::min(glm::length(light.half_u), glm::length(light.half_v));
}

// Corners relative to the light's centre.
std::vector<glm::dvec3> corners_about_centre(Light light) {
  light.centre = glm::dvec3(0.0);
  return light_corners(light);
}

// The corner of a rectangle whose plane through the edge leaves the others on one side: the best of
// the four. Where the edge's line goes through a corner, the plane has the next one, too.
// Places are relative to the light's centre.
std::size_t touched_corner(const std::vector<glm::dvec3>& corners, const glm::dvec3& edge_begin,
                           const glm::dvec3& edge_end, double sign) {
  std::size_t best = 0;
  double best_beyond = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& corner = corners[i];
    const glm::dvec3 n = sign * exact_cross({edge_end, corner}, {edge_begin, corner});
    const double length = glm::length(n);
    const double from_line = length / glm::distance(edge_begin, edge_end);
    if (!(from_line > kOnLine * glm::length(corner))) continue;
    double beyond = -1e300;
    for (const glm::dvec3& other : corners) {
      beyond = std::max(beyond, glm::dot(n / length, other - corner));
    }
    if (beyond < best_beyond) {
      best_beyond = beyond;
      best = i;
    }
  }
  return best;
}

EdgePlanes edge_planes(const Light& light, const glm::dvec3& begin, const glm::dvec3& end) {
  EdgePlanes planes;
  planes.normal = glm::normalize(glm::dvec3(quad_plane(light.centre, begin, end)));
  for (std::size_t i = 0; i < 2; ++i) {
    const double sign = i == 0 ? 1.0 : -1.0;
    if (light.shape == LightShape::rectangle) {
      const std::vector<glm::dvec3> corners = corners_about_centre(light);
      planes.touched[i] = touched_corner(corners, begin - light.centre, end - light.centre, sign);
      planes.touch[i] = corners[planes.touched[i]];
    } else {
      planes.touch[i] = sign * light.radius * planes.normal;
    }
    const glm::dvec4 plane = sign * quad_plane(light.centre + planes.touch[i], begin, end);
    planes.planes[i] = plane / glm::length(glm::dvec3(plane));
  }
  return planes;
}

// Whether nothing is between an edge's front and its back plane.
bool face_to_face(const EdgePlanes& planes) {
  const glm::dvec3 front(planes.planes[0]), back(planes.planes[1]);
  return glm::dot(front, back) < 0.0 && glm::length(glm::cross(front, back)) < kFlat;
}

// Whether a line goes through the light: then no plane through it touches the light.
bool meets_light(const Light& light, const glm::dvec3& point, const glm::dvec3& unit_direction) {
  const glm::dvec3 to_centre = light.centre - point;
  if (light.shape == LightShape::sphere) {
    return glm::length(glm::cross(to_centre, unit_direction)) < light.radius;
  }
  if (light.shape != LightShape::rectangle) return false;
  const glm::dvec3 normal = glm::cross(light.half_u, light.half_v);
  const double slope = glm::dot(normal, unit_direction);
  if (slope == 0.0) return false;
  const glm::dvec3 there = glm::dot(normal, to_centre) / slope * unit_direction - to_centre;
  return std::abs(glm::dot(there, light.half_u)) < glm::dot(light.half_u, light.half_u) &&
         std::abs(glm::dot(there, light.half_v)) < glm::dot(light.half_v, light.half_v);
}

bool has_no_planes(const Light& light, const glm::dvec3& begin, const glm::dvec3& end) {
  const glm::dvec3 a = begin - light.centre;
  const glm::dvec3 b = end - light.centre;
  const double edge = glm::length(b - a);
  const double nearer = std::min(glm::length(a), glm::length(b));
  return edge <= kShortest * nearer ||
         glm::length(glm::cross(a, b)) < kPointsAtLight * edge * nearer ||
         meets_light(light, begin, (end - begin) / edge);
}

// Three planes that close the space above the end plane around a sphere: with it they are a
// tetrahedron, so that a wedge whose sides diverge still ends, within eight planes.
std::array<glm::dvec4, 3> lid_above(const EndPlane& end_plane, const glm::dvec3& centre,
                                    double radius) {
  const auto up = glm::normalize(glm::dvec3(end_plane.plane));
  const auto [u, v] = Across(up);
  std::array<glm::dvec4, 3> lid;
  for (std::size_t i = 0; i < 3; ++i) {
    const double turn = 2.0 * M_PI * static_cast<double>(i) / 3.0;
    const glm::dvec3 out = std::sqrt(0.75) * (std::cos(turn) * u + std::sin(turn) * v) + 0.5 * up;
    lid[i] = glm::dvec4(-out, radius + glm::dot(out, centre));
  }
  return lid;
}

// Planes after the first `kept` that bound no face decide nothing.
void drop_unused(WorldWedge& volume, std::size_t kept) {
  for (std::size_t i = volume.planes.size(); i-- > kept;) {
    const bool used = std::any_of(volume.faces.begin(), volume.faces.end(),
                                  [&](const WedgeFace& face) { return face.plane == i; });
    if (used) continue;
    volume.planes.erase(volume.planes.begin() + static_cast<std::ptrdiff_t>(i));
    for (WedgeFace& face : volume.faces) face.plane -= face.plane > i ? 1 : 0;
  }
}

double reciprocal(const glm::dvec4& plane, const glm::dvec3& direction) {
  return 1.0 / std::max(std::abs(glm::dot(glm::dvec3(plane), direction)), kLeastSlope);
}

}  // namespace

std::vector<LinearWedge> linear_wedges(const Light& light, std::vector<glm::dvec3> loop,
                                       const EndPlane& end_plane, const Bounds& bounds) {
  std::vector<std::size_t> places(loop.size());
  std::iota(places.begin(), places.end(), 0U);
  for (std::size_t i = 0; loop.size() >= 3 && i < loop.size();) {
    const std::size_t next = (i + 1) % loop.size();
    if (has_no_planes(light, loop[i], loop[next])) {
      // Keep the end nearer to the light: its shadow is the larger.
      const bool keep_first =
          glm::distance(loop[i], light.centre) <= glm::distance(loop[next], light.centre);
      const auto left_out = static_cast<std::ptrdiff_t>(keep_first ? next : i);
      loop.erase(loop.begin() + left_out);
      places.erase(places.begin() + left_out);
      i = 0;
    } else {
      ++i;
    }
  }
  std::vector<LinearWedge> wedges;
  const std::size_t n = loop.size();
  if (n < 3) return wedges;
  std::vector<EdgePlanes> planes;
  for (std::size_t i = 0; i < n; ++i) {
    planes.push_back(edge_planes(light, loop[i], loop[(i + 1) % n]));
  }
  std::vector<CornerPlanes> corners;  // at the begin of edge i
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t before = (i + n - 1) % n;
    corners.push_back(
        corner_between({planes[before], planes[i], loop[i] - light.centre,
                        loop[before] - light.centre, loop[(i + 1) % n] - light.centre},
                       light.centre, end_plane));
  }
  const glm::dvec3 centre = 0.5 * (bounds.low + bounds.high);
  const double radius = kLidRadius * bounds.diagonal();
  const std::array<glm::dvec4, 3> lid = lid_above(end_plane, centre, radius);
  const Bounds box{centre - 8.0 * radius, centre + 8.0 * radius};  // holds the tetrahedron
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    const CornerPlanes& left = corners[i];
    const CornerPlanes& right = corners[next];
    LinearWedge wedge;
    wedge.begin = loop[i];
    wedge.end = loop[next];
    wedge.corner = left.decided;
    wedge.corner.place = places[i];
    wedge.corner.touched = planes[i].touched;
    // The side plane at `begin` has the edge that ends there on its positive side: not this one.
    const auto& [front, back] = planes[i].planes;
    const std::array<glm::dvec4, 8> sides{front,           back,   -left.side, right.side,
                                          end_plane.plane, lid[0], lid[1],     lid[2]};
    wedge.volume = intersect_half_spaces(sides, box, kAccuracy * least_half_size(light));
    drop_unused(wedge.volume, kLinearPlanes);
    if (face_to_face(planes[i])) wedge.volume.faces.clear();
    wedge.umbra = {wedge.end, wedge.begin, end_plane.reach(loop[i] - left.front, loop[i]),
                   end_plane.reach(loop[next] - right.front, loop[next])};
    const glm::dvec3 along = glm::normalize(wedge.end - wedge.begin);
    wedge.factors = {reciprocal(front, left.direction),  reciprocal(back, left.direction),
                     reciprocal(front, right.direction), reciprocal(back, right.direction),
                     reciprocal(left.side, along),       reciprocal(right.side, along)};
    wedges.push_back(std::move(wedge));
  }
  return wedges;
}

}  // namespace wedgesim::functional
