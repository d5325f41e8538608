#include "functional/light/coverage.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

double cross_2d(const glm::dvec2& a, const glm::dvec2& b) { return a.x * b.y - a.y * b.x; }

// What is left of a segment: shares of its length that are cut off from its begin and from its end,
// and those left from there on to the other end. Neither is 1 less the other: a point next to one
// end keeps its digits, however far away the other is.
struct Cut {
  double begin = 0.0, left_of_begin = 1.0;
  double end = 0.0, left_of_end = 1.0;
  // Keeps what is between two values, one at each end, and not negative.
  void keep(double at_begin, double at_end) {
    const double share = at_begin / (at_begin - at_end);
    const double left = at_end / (at_end - at_begin);
    if (at_begin < 0.0 && at_end < 0.0) {
      begin = end = 1.0;
    } else if (at_begin < 0.0 && share > begin) {
      begin = share;
      left_of_begin = left;
    } else if (at_end < 0.0 && left > end) {
      end = left;
      left_of_end = share;
    }
  }
  bool all() const { return !(begin + end < 1.0); }
};

// The part of a segment between two homogeneous points that projects into the square [−1, 1]²;
// it has third coordinates ≥ 0. Nothing if none does.
struct Segment {
  glm::dvec3 begin, end;
};
std::optional<Segment> inside_square(const glm::dvec3& a, const glm::dvec3& b) {
  Cut cut;
  cut.keep(a.z - a.x, b.z - b.x);
  cut.keep(a.z + a.x, b.z + b.x);
  cut.keep(a.z - a.y, b.z - b.y);
  cut.keep(a.z + a.y, b.z + b.y);
  if (cut.all()) return std::nullopt;
  return Segment{cut.left_of_begin * a + cut.begin * b, cut.end * a + cut.left_of_end * b};
}

glm::dvec2 project(const glm::dvec3& h) {
  return h.z > 0.0 ? glm::dvec2(h) / h.z : glm::dvec2(0.0);
}

// Where the ray from the centre through q leaves the square [−1, 1]².
glm::dvec2 square_exit(const glm::dvec2& q) {
  const double reach = std::max(std::abs(q.x), std::abs(q.y));
  return reach > 0.0 ? q / reach : glm::dvec2(1.0, 0.0);
}

}  // namespace

glm::dmat4 light_from_world(const Light& light) {
  glm::dmat4 m(1.0);
  std::array<glm::dvec3, 3> rows{glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, 1)};
  if (light.shape == LightShape::rectangle) {
    const glm::dvec3 normal = glm::normalize(glm::cross(light.half_u, light.half_v));
    rows = {light.half_u / glm::dot(light.half_u, light.half_u),
            light.half_v / glm::dot(light.half_v, light.half_v), normal};
  } else if (light.shape == LightShape::sphere && light.radius > 0.0) {
    for (glm::dvec3& row : rows) row /= light.radius;
  }
  for (int i = 0; i < 3; ++i) {
    const glm::dvec3& row = rows[static_cast<std::size_t>(i)];
    for (int j = 0; j < 3; ++j) m[j][i] = row[j];
    m[3][i] = -glm::dot(row, light.centre);
  }
  return m;
}

std::optional<Chord> project_edge(const glm::dvec3& point, const glm::dvec3& begin,
                                  const glm::dvec3& end) {
  // Project e from p: (p.h·e − e.h·p) / (p.h − e.h), kept as numerator and denominator.
  const auto seen = [&](const glm::dvec3& e) {
    return glm::dvec3(point.z * e.x - e.z * point.x, point.z * e.y - e.z * point.y, point.z - e.z);
  };
  const std::optional<Segment> inside = inside_square(seen(begin), seen(end));
  if (!inside) return std::nullopt;
  return Chord{project(inside->begin), project(inside->end)};
}

double rectangle_coverage(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end) {
  const std::optional<Chord> chord = project_edge(point, begin, end);
  if (!chord) return 0.0;
  auto [p, q] = *chord;
  if (cross_2d(p, q) < 0.0) std::swap(p, q);
  // The corners between the rays, at most two, by the rays themselves: where the exits lie would
  // not do, as rounding may put them past a corner the wrong way round.
  std::vector<glm::dvec2> corners;
  for (const glm::dvec2 corner : {glm::dvec2(1, -1), {1, 1}, {-1, 1}, {-1, -1}}) {
    if (cross_2d(p, corner) > 0.0 && cross_2d(corner, q) > 0.0) corners.push_back(corner);
  }
  if (corners.size() == 2 && cross_2d(corners[0], corners[1]) > 0.0) {
    std::swap(corners[0], corners[1]);
  }
  // Outline: p, q, where q's ray leaves the square, clockwise to where p's ray leaves it.
  std::vector<glm::dvec2> outline{p, q, square_exit(q)};
  outline.insert(outline.end(), corners.begin(), corners.end());
  outline.push_back(square_exit(p));
  double doubled = 0.0;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    doubled += cross_2d(outline[i], outline[(i + 1) % outline.size()]);
  }
  return std::min(0.5, std::abs(doubled) / 8.0);
}

double sphere_coverage(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end) {
  const double distance_squared = glm::dot(point, point);
  if (!(distance_squared > 1.0)) return 0.0;
  const double distance = std::sqrt(distance_squared);
  const glm::dvec3 axis = -point / distance;
  const double tan_half = 1.0 / std::sqrt(distance_squared - 1.0);
  const Across across(axis);
  const auto in_cone = [&](const glm::dvec3& e) {
    const glm::dvec3 d = e - point;
    // The point itself is on the axis: it adds nothing across but its rounding.
    return glm::dvec3(glm::dot(e, across.u), glm::dot(e, across.v), tan_half * glm::dot(d, axis));
  };
  // First to the square around the disc: what is left is in front of the point and bounded.
  const std::optional<Segment> inside = inside_square(in_cone(begin), in_cone(end));
  if (!inside) return 0.0;
  const glm::dvec2 p = project(inside->begin);
  const glm::dvec2 q = project(inside->end);
  // |p + s (q − p)| = 1.
  const glm::dvec2 d = q - p;
  const double dd = glm::dot(d, d);
  const double pd = glm::dot(p, d);
  const double root = pd * pd - dd * (glm::dot(p, p) - 1.0);
  if (!(root > 0.0) || dd == 0.0) return 0.0;
  const double s_low = std::max(0.0, (-pd - std::sqrt(root)) / dd);
  const double s_high = std::min(1.0, (-pd + std::sqrt(root)) / dd);
  if (!(s_low < s_high)) return 0.0;
  const glm::dvec2 c0 = p + s_low * d;
  const glm::dvec2 c1 = s_high < 1.0 ? p + s_high * d : q;
  const double triangle = std::abs(cross_2d(c0, c1));
  const double sector = std::abs(std::atan2(cross_2d(c0, c1), glm::dot(c0, c1)));
  return std::clamp((sector - triangle) / (2.0 * M_PI), 0.0, 0.5);
}

double coverage(LightShape shape, const glm::dvec3& point, const glm::dvec3& begin,
                const glm::dvec3& end) {
  switch (shape) {
    case LightShape::rectangle:
      return rectangle_coverage(point, begin, end);
    case LightShape::sphere:
      return sphere_coverage(point, begin, end);
    case LightShape::point:
      return 0.0;
  }
  return 0.0;
}

}  // namespace wedgesim::functional
