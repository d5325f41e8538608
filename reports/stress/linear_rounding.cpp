#include "reports/stress/linear_rounding.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec4.hpp>
#include <limits>
#include <map>

#include "functional/raster/exact_cross.h"

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
glm::dvec4 world_plane(const traces::TraceView& trace, const traces::fb::Wedge& wedge, Side side) {
  const traces::fb::Plane& p = trace.planes[plane_of(wedge, side)];
  const auto& columns = *trace.header.camera.window_from_world.columns();
  glm::dvec4 world(0.0);
  for (int column = 0; column < 4; ++column) {
    const auto at = static_cast<std::uint16_t>(4 * column);
    world[column] = p.a() * columns[at] + p.b() * columns[static_cast<std::uint16_t>(at + 1)] +
                    p.c() * columns[static_cast<std::uint16_t>(at + 2)] +
                    p.d() * columns[static_cast<std::uint16_t>(at + 3)];
  }
  world.w += glm::dot(glm::dvec3(world), vec(trace.header.lights[wedge.light()].centre));
  return world;
}

// The sine of the angle between two planes, and the way in which they meet.
glm::dvec3 meeting(const glm::dvec4& a, const glm::dvec4& b) {
  return functional::exact_cross(functional::Difference(glm::normalize(glm::dvec3(a))),
                                 functional::Difference(glm::normalize(glm::dvec3(b))));
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
    : trace_(trace), losses_(trace.wedges.size()), lost_(trace.wedges.size()) {
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
  std::map<std::uint32_t, std::uint32_t> by_left;  // plane to wedge
  const auto count = static_cast<std::uint32_t>(trace_.wedges.size());
  for (std::uint32_t w = 0; w < count; ++w) {
    if (trace_.wedges[w].kind() == traces::fb::WedgeKind_linear) {
      by_left.emplace(plane_of(trace_.wedges[w], kLeft), w);
    }
  }
  std::vector<Corner> corners;
  for (std::uint32_t w = 0; w < count; ++w) {
    if (trace_.wedges[w].kind() != traces::fb::WedgeKind_linear) continue;
    const auto next = by_left.find(plane_of(trace_.wedges[w], kRight));
    if (next != by_left.end()) corners.push_back({w, next->second});
  }
  return corners;
}

// The normals of front and back plane are products of the ways to the edge's ends, or nearly so.
void LinearRounding::lose_edges(const std::vector<Corner>& corners) {
  std::vector<std::array<glm::dvec3, 2>> ends(losses_.size());  // from the light's centre
  for (const auto& [w, next] : corners) {
    const auto plane = [&](Side side) { return world_plane(trace_, trace_.wedges[w], side); };
    const glm::dvec3 vertex = common_point(plane(kFront), plane(kBack), plane(kRight));
    ends[w][1] = ends[next][0] = vertex;
    losses_[w][kRight].distance = losses_[next][kLeft].distance = known(glm::length(vertex));
  }
  for (std::size_t w = 0; w < losses_.size(); ++w) {
    Losses& loss = losses_[w];
    const auto& [begin, end] = ends[w];
    const double product = glm::length(begin) * glm::length(end);
    const double turn = known(kUnit * product / glm::length(glm::cross(begin, end)));
    const double farther = std::max(loss[kLeft].distance, loss[kRight].distance);
    loss[kFront] = loss[kBack] = {std::min(1.0, turn), farther};
  }
}

void LinearRounding::lose_sides(const Corner& corner) {
  const auto& [w, next] = corner;
  const auto line = [&](Side side) {
    return meeting(world_plane(trace_, trace_.wedges[w], side),
                   world_plane(trace_, trace_.wedges[next], side));
  };
  const glm::dvec3 front = line(kFront), back = line(kBack);
  const double at_front = glm::length(front), at_back = glm::length(back);
  const double between = glm::length(glm::cross(front / at_front, back / at_back));
  const auto turned = [&](Side side) { return losses_[w][side].turn + losses_[next][side].turn; };
  const double turn = known((turned(kFront) / at_front + turned(kBack) / at_back) / between);
  losses_[w][kRight].turn = losses_[next][kLeft].turn = std::min(1.0, turn);
}

double LinearRounding::operator()(std::uint32_t wedge, double x, double y, double z) const {
  if (lost_[wedge]) return 1.0;
  const traces::fb::Wedge& record = trace_.wedges[wedge];
  const auto& to_world = *trace_.header.camera.world_from_window.columns();
  glm::dvec4 point(0.0);
  for (int row = 0; row < 4; ++row) {
    const auto at = [&](int column) {
      return to_world[static_cast<std::uint16_t>(4 * column + row)];
    };
    point[row] = at(0) * x + at(1) * y + at(2) * z + at(3);
  }
  const glm::dvec3 light = vec(trace_.header.lights[record.light()].centre);
  const double away = glm::distance(glm::dvec3(point) / point.w, light);
  std::array<double, 4> value{}, error{}, size{};
  for (std::size_t side = 0; side < value.size(); ++side) {
    const std::uint32_t reference = (*record.planes())[static_cast<std::uint16_t>(side)];
    const traces::fb::Plane& p = trace_.planes[traces::plane_index(reference)];
    const double sign = traces::is_minus(reference) ? -1.0 : 1.0;
    value[side] = sign * (((p.a() * x + p.b() * y) + p.c() * z) + p.d());
    const Loss& loss = losses_[wedge][side];
    const glm::dvec3 normal(world_plane(trace_, record, static_cast<Side>(side)));
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
