#include "reports/stress/light_rounding.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <glm/vec4.hpp>

#include "functional/light/coverage.h"
#include "functional/scene/across.h"

namespace wedgesim::reports::stress {
namespace {

// Of a sum of four products, half units in the last place of its terms.
constexpr double kUnit = 4.0 * 0x1p-53;

glm::dvec3 vec(const traces::fb::Vec3& v) { return {v.x(), v.y(), v.z()}; }

// A vector and by how much each of its coordinates may be off.
struct Rounded {
  glm::dvec3 value{0.0}, error{0.0};
};

// The pixel's point in light space.
Rounded point_of(const traces::fb::Matrix4& light_from_window, const glm::dvec4& window) {
  std::array<double, 4> value{}, terms{};
  for (std::size_t row = 0; row < 4; ++row) {
    for (std::size_t column = 0; column < 4; ++column) {
      const double term =
          (*light_from_window.columns())[static_cast<std::uint16_t>(4 * column + row)] *
          window[static_cast<int>(column)];
      value[row] += term;
      terms[row] += std::fabs(term);
    }
  }
  Rounded point;
  for (int i = 0; i < 3; ++i) {
    const auto k = static_cast<std::size_t>(i);
    point.value[i] = value[k] / value[3];
    point.error[i] =
        kUnit * (terms[k] + std::fabs(point.value[i]) * terms[3]) / std::fabs(value[3]);
  }
  return point;
}

// An end of an edge as the point sees it, homogeneous: the light is within -1 and 1.
Rounded in_rectangle(const Rounded& point, const glm::dvec3& e) {
  const glm::dvec3& p = point.value;
  const glm::dvec3 size = glm::abs(e), far = glm::abs(p), off = point.error;
  return {{p.z * e.x - e.z * p.x, p.z * e.y - e.z * p.y, p.z - e.z},
          {off.z * size.x + size.z * off.x + kUnit * (far.z * size.x + size.z * far.x),
           off.z * size.y + size.z * off.y + kUnit * (far.z * size.y + size.z * far.y),
           off.z + kUnit * (far.z + size.z)}};
}
Rounded in_disc(const Rounded& point, const glm::dvec3& e) {
  const double distance = glm::length(point.value);
  const glm::dvec3 axis = -point.value / distance;
  const functional::Across across(axis);
  const double tan_half = 1.0 / std::sqrt(distance * distance - 1.0);
  const double size = glm::length(e);
  const double off = glm::length(point.error);
  const double turned = size * (off / distance + kUnit);
  return {{glm::dot(e, across.u), glm::dot(e, across.v), tan_half * (glm::dot(e, axis) + distance)},
          {turned, turned, tan_half * (turned + off + kUnit * distance)}};
}

// What is left of an edge before the light, or before the square around its disc.
struct Part {
  double low = 0.0, high = 1.0;
  void keep(double from, double to) {
    if (from < 0.0 && to < 0.0) high = -1.0;
    if (from < 0.0 && to >= 0.0) low = std::max(low, from / (from - to));
    if (to < 0.0 && from >= 0.0) high = std::min(high, from / (from - to));
  }
};

// The distance of the line through two points from the origin.
double off_centre(const glm::dvec2& p, const glm::dvec2& q) {
  return std::fabs(p.x * q.y - p.y * q.x) / glm::distance(p, q);
}

}  // namespace

double light_rounding(const traces::TraceView& trace, const traces::fb::Wedge& wedge, double x,
                      double y, double z) {
  const traces::Light& light = trace.header.lights[wedge.light()];
  const Rounded point = point_of(light.light_from_window, {x, y, z, 1.0});
  const bool disc = light.shape == traces::fb::LightShape_sphere;
  const auto seen = [&](const traces::fb::Vec3& end) {
    return disc ? in_disc(point, vec(end)) : in_rectangle(point, vec(end));
  };
  const Rounded a = seen(wedge.edge_begin());
  const Rounded b = seen(wedge.edge_end());
  Part part;
  for (const int i : {0, 1}) {
    for (const double side : {-1.0, 1.0}) {
      part.keep(a.value.z + side * a.value[i], b.value.z + side * b.value[i]);
    }
  }
  if (!(part.low < part.high)) return 0.0;
  const auto at = [&](double s) { return a.value + s * (b.value - a.value); };
  const glm::dvec3 p = at(part.low), q = at(part.high);
  const double scale = std::min(p.z, q.z);
  if (!(scale > 0.0)) return 1.0;
  const auto most = [](const glm::dvec3& v) { return std::max({v.x, v.y, v.z}); };
  const double clipped = kUnit * (most(glm::abs(a.value)) + most(glm::abs(b.value)));
  const double moved = (most(a.error) + most(b.error) + clipped) / scale;
  if (off_centre(glm::dvec2(p) / p.z, glm::dvec2(q) / q.z) > moved) return moved;
  // The plane of its shadow quad, made from other numbers, may say that the point is on the other
  // side: what the edge covers then counts with the wrong sign, what it leaves of a half instead.
  const double covers = functional::coverage(
      disc ? functional::LightShape::sphere : functional::LightShape::rectangle, point.value,
      vec(wedge.edge_begin()), vec(wedge.edge_end()));
  return moved + 2.0 * std::min(covers, 0.5 - covers);
}

}  // namespace wedgesim::reports::stress
