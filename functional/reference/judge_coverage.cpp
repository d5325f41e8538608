#include "functional/reference/judge_coverage.h"

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <utility>
#include <vector>

#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// A point of the light's plane, homogeneous; and a half-plane, dot ≥ 0.
using Seen = RealVector;
using HalfPlane = RealVector;

// More than what double rounds off, relative to the terms.
constexpr double kRounding = 1e-12;

// Keeps the part of a segment where what is wa and wb at its ends is positive; false if nothing is.
bool keep_part(RealVector& a, RealVector& b, const Real& wa, const Real& wb) {
  if (wa <= 0 && wb <= 0) return false;
  if (wa >= 0 && wb >= 0) return true;
  const RealVector middle = a + Real(wa / (wa - wb)) * (b - a);
  if (wa < 0) a = middle;
  if (wb < 0) b = middle;
  return true;
}

std::vector<Seen> clip(const std::vector<Seen>& polygon, const HalfPlane& half_plane) {
  std::vector<Seen> kept;
  if (polygon.empty()) return kept;
  kept.reserve(polygon.size() + 1);
  const Seen* p = &polygon.back();
  Real at_p = dot(half_plane, *p);
  for (const Seen& q : polygon) {
    const Real at_q = dot(half_plane, q);
    if ((at_p >= 0) != (at_q >= 0)) kept.push_back(*p + Real(at_p / (at_p - at_q)) * (q - *p));
    if (at_q >= 0) kept.push_back(q);
    p = &q;
    at_p = at_q;
  }
  return kept;
}

Real doubled_area(const std::vector<Seen>& polygon) {
  Real sum = 0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Seen& p = polygon[i];
    const Seen& q = polygon[(i + 1) % polygon.size()];
    sum += p.x * q.y - q.x * p.y;
  }
  return abs(sum);
}

// Values of the size that rounding leaves are 0.
void drop_rounding(Real& value, double terms) {
  if (std::abs(value.convert_to<double>()) <= kRealTie * terms) value = 0;
}

// The way from the centre to a projected end; (1, 0) of the centre itself.
RealVector way_to(const Seen& seen) {
  if (seen.x == 0 && seen.y == 0) return {1, 0, 0};
  return {seen.x, seen.y, 0};
}

}  // namespace

JudgedLight::JudgedLight(const Light& light) {
  if (light.shape != LightShape::rectangle) {
    const bool in_radii = light.shape == LightShape::sphere && light.radius > 0.0;
    const Real scale = in_radii ? Real(1 / Real(light.radius)) : Real(1);
    rows_ = {RealVector(scale, 0, 0), RealVector(0, scale, 0), RealVector(0, 0, scale)};
    return;
  }
  const RealVector u(light.half_u);
  const RealVector v(light.half_v);
  const RealVector normal = cross(u, v);
  const Real scale = 1 / dot(normal, normal);
  rows_ = {scale * cross(v, normal), scale * cross(normal, u), scale * normal};
}

RealVector JudgedLight::operator()(const RealVector& p) const {
  return {dot(rows_[0], p), dot(rows_[1], p), dot(rows_[2], p)};
}

Real judged_rectangle_coverage(const RealVector& point, const RealVector& begin,
                               const RealVector& end) {
  if (point.z <= 0) return 0;
  const double at_point = magnitude(point);
  const std::array<double, 2> at_end{magnitude(begin), magnitude(end)};
  // Homogeneous: where the ray from the point through e meets the light's plane.
  const auto seen = [&](const RealVector& e, double at_e) {
    Seen s = point.z * e - e.z * point;
    drop_rounding(s.x, at_point * at_e);
    drop_rounding(s.y, at_point * at_e);
    s.z = point.z - e.z;
    drop_rounding(s.z, at_point + at_e);
    return s;
  };
  Seen p = seen(begin, at_end[0]);
  Seen q = seen(end, at_end[1]);
  const double terms = at_point * (at_end[0] * magnitude(q) + at_end[1] * magnitude(p));
  if (!keep_part(p, q, Real(p.z), Real(q.z))) return 0;
  HalfPlane beyond = cross(p, q);
  drop_rounding(beyond.x, terms);
  drop_rounding(beyond.y, terms);
  drop_rounding(beyond.z, terms);
  if (beyond.x == 0 && beyond.y == 0 && beyond.z == 0) return 0;
  RealVector left = way_to(p);
  RealVector right = way_to(q);
  const Real turn = cross(left, right).z;
  // Counter-clockwise from left to right, and the centre on the other side of the edge.
  if (turn < 0) {
    std::swap(left, right);
  } else {
    beyond = Real(-1) * beyond;
  }
  std::vector<Seen> light{{-1, -1, 1}, {1, -1, 1}, {1, 1, 1}, {-1, 1, 1}};
  light = clip(light, {-left.y, left.x, 0});
  light = clip(light, {right.y, -right.x, 0});
  light = clip(light, beyond);
  return doubled_area(light) / 8;
}

Real judged_sphere_coverage(const RealVector& point, const RealVector& begin,
                            const RealVector& end) {
  const Real distance_squared = dot(point, point);
  if (distance_squared <= 1) return 0;
  RealVector a = begin - point;
  RealVector b = end - point;
  const RealVector normal = cross(a, b);
  const double terms = magnitude(point) + magnitude(begin) + magnitude(end);
  if (magnitude(normal) <= kRealTie * terms * terms) return 0;
  const RealVector towards = Real(-1) * point;  // the light, of length sqrt(distance_squared)
  // Between the point and the sphere: not behind the point, nor beyond the circle where its tangent
  // cone touches (x·point = 1). What is in the cone cannot pass that circle outside the sphere.
  const auto before_light = [&](const RealVector& e) {
    return Real(distance_squared - 1 - dot(e, towards));
  };
  if (!keep_part(a, b, before_light(a), before_light(b))) return 0;
  if (!keep_part(a, b, dot(a, towards), dot(b, towards))) return 0;
  // In the plane across the cone's axis where the disc's radius is 1, the edge's line has its foot
  // at `foot` from the centre and goes along n × axis.
  const Real root = sqrt(Real(distance_squared - 1));
  const RealVector along = cross(normal, towards);
  const Real along_length = sqrt(dot(along, along));
  if (along_length == 0) return 0;
  const Real foot = abs(dot(normal, towards)) * root / along_length;
  if (foot >= 1) return 0;
  const Real half_chord = sqrt(Real(1 - foot * foot));
  const Real scale = sqrt(distance_squared) * root;
  // An end's place along the line, kept within the disc.
  const auto place = [&](const RealVector& e) {
    const Real side = dot(e, along) * scale;
    const Real depth = dot(e, towards) * along_length;
    if (abs(side) >= half_chord * depth) return Real(side < 0 ? -half_chord : half_chord);
    return Real(side / depth);
  };
  const Real from = place(a);
  const Real to = place(b);
  const Real length = abs(Real(to - from));
  const Real angle = atan2(Real(foot * length), Real(foot * foot + from * to));
  static const Real two_pi = 2 * acos(Real(-1));
  return (angle - foot * length) / two_pi;
}

Real judged_coverage(LightShape shape, const RealVector& point, const RealVector& begin,
                     const RealVector& end) {
  switch (shape) {
    case LightShape::rectangle:
      return judged_rectangle_coverage(point, begin, end);
    case LightShape::sphere:
      return judged_sphere_coverage(point, begin, end);
    case LightShape::point:
      break;
  }
  return 0;
}

CoverageFilter::CoverageFilter(LightShape shape, const RealVector& point)
    : rectangle_(shape == LightShape::rectangle), point_(to_double(point)) {
  if (rectangle_) return;
  const Real distance_squared = dot(point, point);
  reached_ = distance_squared > 1;
  if (!reached_) return;
  const Real tangent = 1 / sqrt(Real(distance_squared - 1));
  const RealVector axis = unit(Real(-1) * point);
  const Across across(to_double(axis));
  axis_ = to_double(tangent * axis);
  across_u_ = across.u;
  across_v_ = across.v;
}

CoverageFilter::Seen CoverageFilter::see(const glm::dvec3& e) const {
  const glm::dvec3& p = point_;
  const double at_e = std::abs(e.x) + std::abs(e.y) + std::abs(e.z);
  const double at_p = std::abs(p.x) + std::abs(p.y) + std::abs(p.z);
  if (rectangle_) {
    return {p.z * e.x - e.z * p.x, p.z * e.y - e.z * p.y, p.z - e.z,
            kRounding * (at_p * at_e + at_p + at_e)};
  }
  const glm::dvec3 d = e - p;
  const double steepness = 1.0 + glm::length(axis_);
  return {glm::dot(d, across_u_), glm::dot(d, across_v_), glm::dot(d, axis_),
          kRounding * (at_p + at_e) * steepness};
}

bool CoverageFilter::may_cover(const glm::dvec3& begin, const glm::dvec3& end) const {
  if (!reached_) return false;
  const Seen a = see(begin);
  const Seen b = see(end);
  const auto beyond = [&](double at_a, double at_b) {
    return at_a < -2.0 * a.error && at_b < -2.0 * b.error;
  };
  return !(beyond(a.w, b.w) || beyond(a.w - a.u, b.w - b.u) || beyond(a.w + a.u, b.w + b.u) ||
           beyond(a.w - a.v, b.w - b.v) || beyond(a.w + a.v, b.w + b.v));
}

}  // namespace wedgesim::functional
