#include "reports/stress/linear_rounding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <map>

#include "functional/geometry/linear_wedge.h"
#include "functional/raster/exact_cross.h"
#include "reports/stress/world.h"

namespace wedgesim::reports::stress {
namespace {

// Of a plane made from a few points, half units in the last place.
constexpr double kUnit = 8.0 * 0x1p-53;
// A plane that may be turned by this much, in rad, may be anywhere.
constexpr double kLost = 0.1;
enum Side { kFront, kBack, kLeft, kRight };

glm::dvec3 vec(const traces::fb::Vec3& v) { return {v.x(), v.y(), v.z()}; }

std::uint32_t plane_of(const traces::fb::Wedge& wedge, Side side) {
  return traces::plane_index((*wedge.planes())[static_cast<std::uint16_t>(side)]);
}

// A wedge's plane in the world, about the light's centre; not a unit normal.
glm::dvec4 about_light(const traces::TraceView& trace, const traces::fb::Wedge& wedge, Side side) {
  const traces::fb::Plane& p = trace.planes[plane_of(wedge, side)];
  glm::dvec4 world = world_plane(trace, {p.a(), p.b(), p.c(), p.d()});
  world.w += glm::dot(glm::dvec3(world), vec(trace.header.lights[wedge.light()].centre));
  return world;
}

// The point of the light, from its centre, that a plane touches.
glm::dvec3 touch(const traces::Light& light, const glm::dvec4& plane) {
  const glm::dvec3 normal(plane);
  if (light.shape != traces::fb::LightShape_rectangle) {
    return -plane.w / glm::dot(normal, normal) * normal;
  }
  const glm::dvec3 u = vec(light.half_u), v = vec(light.half_v);
  const auto off = [&](const glm::dvec3& p) { return std::fabs(glm::dot(normal, p) + plane.w); };
  return std::ranges::min({-u - v, u - v, u + v, v - u}, {}, off);
}

// Where two front, or two back planes of neighbours meet: the point of that line nearest to the
// light's centre, from there, and how far off it may be. Planes that are all but one have a ray
// from between the points that they touch.
struct Meeting {
  glm::dvec3 point;
  double error = 0.0;
};
Meeting meeting(const glm::dvec3& a, const glm::dvec3& touch_a, const glm::dvec3& b,
                const glm::dvec3& touch_b, double turn) {
  const double size = glm::length(touch_a) + glm::length(touch_b);
  const glm::dvec3 way =
      functional::exact_cross(functional::Difference(a), functional::Difference(b));
  const double sine = glm::length(way);
  if (sine < functional::kLeastMeetingSine) return {0.5 * (touch_a + touch_b), kUnit * size};
  const glm::dvec3 point =
      (glm::dot(a, touch_a) * glm::cross(b, way) + glm::dot(b, touch_b) * glm::cross(way, a)) /
      (sine * sine);
  return {point, (turn + kUnit) * (size + glm::length(point)) / sine};
}

glm::dvec3 common_point(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec4& c) {
  const glm::dvec3 m(a), n(b), o(c);
  const glm::dvec3 no = glm::cross(n, o), om = glm::cross(o, m), mn = glm::cross(m, n);
  return -(a.w * no + b.w * om + c.w * mn) / glm::dot(m, no);
}

double known(double value) {
  return std::isfinite(value) ? value : std::numeric_limits<double>::max();
}

}  // namespace

LinearRounding::LinearRounding(const traces::TraceView& trace)
    : trace_(trace),
      ends_(trace.wedges.size()),
      losses_(trace.wedges.size()),
      lost_(trace.wedges.size()) {
  const std::vector<Corner> all = corners();
  lose_edges(all);
  for (const Corner& corner : all) lose_sides(corner);
  for (const auto& [w, next] : all) {
    const auto is_lost = [&](std::uint32_t wedge) {
      return std::max(losses_[wedge][kLeft].turn, losses_[wedge][kRight].turn) >= kLost;
    };
    if (is_lost(w) || is_lost(next)) lost_[w] = lost_[next] = true;
  }
}

std::vector<LinearRounding::Corner> LinearRounding::corners() const {
  std::multimap<std::uint32_t, std::uint32_t> by_left;  // plane to wedge
  const auto count = static_cast<std::uint32_t>(trace_.wedges.size());
  for (std::uint32_t w = 0; w < count; ++w) {
    if (trace_.wedges[w].kind() == traces::fb::WedgeKind_linear) {
      by_left.emplace(plane_of(trace_.wedges[w], kLeft), w);
    }
  }
  std::vector<Corner> corners;
  for (std::uint32_t w = 0; w < count; ++w) {
    if (trace_.wedges[w].kind() != traces::fb::WedgeKind_linear) continue;
    // Corners opposite one another in a symmetric loop share their plane, too: the next wedge is
    // the one that begins where this one ends.
    const auto [first, last] = by_left.equal_range(plane_of(trace_.wedges[w], kRight));
    const glm::dvec3 end = vertex(w, kRight);
    const auto next = std::min_element(first, last, [&](const auto& a, const auto& b) {
      return glm::distance(vertex(a.second, kLeft), end) <
             glm::distance(vertex(b.second, kLeft), end);
    });
    if (next != last) corners.push_back({w, next->second});
  }
  return corners;
}

// The normals of front and back plane are products of the ways to the edge's ends from a point of
// the light, which is known to its own rounding; they go through that point.
void LinearRounding::lose_edges(const std::vector<Corner>& corners) {
  for (const auto& [w, next] : corners) ends_[w][1] = ends_[next][0] = vertex(w, kRight);
  for (std::uint32_t w = 0; w < losses_.size(); ++w) {
    const auto& [begin, end] = ends_[w];
    const double product = glm::length(begin) * glm::length(end);
    const double turn = known(kUnit * product / glm::length(glm::cross(begin, end)));
    for (const Side side : {kFront, kBack}) {
      const glm::dvec3 from = touched(w, side);
      const double off_line =
          glm::length(glm::cross(begin - from, end - from)) / glm::distance(begin, end);
      const double moved = known(kUnit * glm::length(from) / off_line);
      losses_[w][side] = {std::min(1.0, turn + moved), glm::length(from)};
    }
  }
}

// Of the edge, where its front and back plane meet a side plane.
glm::dvec3 LinearRounding::vertex(std::uint32_t wedge, std::size_t side) const {
  const auto plane = [&](std::size_t of) {
    return about_light(trace_, trace_.wedges[wedge], static_cast<Side>(of));
  };
  return common_point(plane(kFront), plane(kBack), plane(side));
}

void LinearRounding::lose_sides(const Corner& corner) {
  const auto& [w, next] = corner;
  const auto line = [&](Side side) {
    const auto normal = [&](std::uint32_t wedge) {
      return glm::normalize(glm::dvec3(about_light(trace_, trace_.wedges[wedge], side)));
    };
    return meeting(normal(w), touched(w, side), normal(next), touched(next, side),
                   losses_[w][side].turn + losses_[next][side].turn);
  };
  const Meeting front = line(kFront), back = line(kBack);
  const glm::dvec3& at = ends_[w][1];
  const glm::dvec3 ray = at - front.point;
  const double apart = glm::length(glm::cross(ray, back.point - front.point)) / glm::length(ray);
  const double size = std::max(glm::length(touched(w, kFront)), glm::length(touched(w, kBack)));
  // Of a plane made otherwise, by the quads, nothing is in a trace.
  const double turn =
      apart > functional::kOneLine * size ? kUnit + (front.error + back.error) / apart : 1.0;
  const double nearer = std::min(glm::length(ends_[w][0]), glm::length(ends_[next][1]));
  const bool far = glm::length(at) > functional::kFarVertex * nearer;
  losses_[w][kRight] = losses_[next][kLeft] = {std::min(1.0, known(turn)),
                                               known(glm::length(far ? front.point : at))};
}

glm::dvec3 LinearRounding::touched(std::uint32_t wedge, std::size_t side) const {
  const traces::fb::Wedge& record = trace_.wedges[wedge];
  return touch(trace_.header.lights[record.light()],
               about_light(trace_, record, static_cast<Side>(side)));
}

double LinearRounding::operator()(std::uint32_t wedge, double x, double y, double z) const {
  if (lost_[wedge]) return 1.0;
  const traces::fb::Wedge& record = trace_.wedges[wedge];
  const glm::dvec4 point = world_point(trace_, x, y, z);
  const glm::dvec3 light = vec(trace_.header.lights[record.light()].centre);
  const double away = glm::distance(glm::dvec3(point) / point.w, light);
  std::array<double, 4> value{}, error{}, size{};
  for (std::size_t side = 0; side < value.size(); ++side) {
    const std::uint32_t reference = (*record.planes())[static_cast<std::uint16_t>(side)];
    const traces::fb::Plane& p = trace_.planes[traces::plane_index(reference)];
    const double sign = traces::is_minus(reference) ? -1.0 : 1.0;
    value[side] = sign * (((p.a() * x + p.b() * y) + p.c() * z) + p.d());
    const Loss& loss = losses_[wedge][side];
    const glm::dvec3 normal(about_light(trace_, record, static_cast<Side>(side)));
    // The value in the window is that in the world over the distance of view.
    size[side] = glm::length(normal);
    error[side] = loss.turn * (loss.distance + away) * size[side] * point.w;
    if (value[side] < -error[side]) return 0.0;
  }
  for (std::size_t side = 0; side < value.size(); ++side) {
    if (value[side] <= error[side]) return 1.0;
  }
  const auto& factors = *record.linear_factors();
  // A plane's distance along a way is off by its own error, and by the turn of the way, which its
  // factor multiplies; that moves the ratio by a quarter of it at most.
  const auto of_ratio = [&](Side a, std::uint16_t at_a, Side b, std::uint16_t at_b, double turn) {
    const double steep = size[a] * factors[at_a] + size[b] * factors[at_b];
    return (error[a] * factors[at_a] + error[b] * factors[at_b]) /
               (value[a] * factors[at_a] + value[b] * factors[at_b]) +
           0.25 * turn * steep;
  };
  const auto turn = [&](Side side) { return losses_[wedge][side].turn; };
  return std::min(1.0, of_ratio(kFront, 0, kBack, 1, turn(kLeft)) +
                           of_ratio(kFront, 2, kBack, 3, turn(kRight)) +
                           of_ratio(kLeft, 4, kRight, 5, std::max(turn(kLeft), turn(kRight))));
}

}  // namespace wedgesim::reports::stress
