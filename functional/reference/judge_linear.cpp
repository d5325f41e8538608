#include "functional/reference/judge_linear.h"

#include <algorithm>

namespace wedgesim::functional {
namespace {

// Corners of a rectangle that touch a plane but for this part of its size are one choice.
constexpr double kTouching = 1e-9;

double length_of(const RealVector& v) { return sqrt(dot(v, v)).convert_to<double>(); }

// 0 of a vector without length.
Direction direction(const RealVector& v, double terms) {
  const double length = length_of(v);
  if (length == 0.0) return {{}, 1.0};
  return {unit(v), std::max(1.0, terms / length)};
}
Direction across(const Direction& a, const Direction& b) {
  return direction(cross(a.way, b.way), a.loss + b.loss);
}
Direction reversed(const Direction& d) { return {Real(-1) * d.way, d.loss}; }
Direction turned_to(const Direction& d, const RealVector& way) {
  return dot(d.way, way) < 0 ? reversed(d) : d;
}
// The part of v across a unit vector, made one.
Direction part_across(const RealVector& v, const Direction& axis) {
  return direction(cross(axis.way, cross(v, axis.way)), axis.loss * length_of(v));
}

// The inward normal of a shadow quad whose light were at a point.
Direction quad_normal(const RealVector& light, const RealVector& begin, const RealVector& end) {
  const RealVector edge = end - begin;
  const RealVector ray = begin - light;
  return direction(cross(edge, ray), length_of(edge) * length_of(ray));
}

// The corner whose plane through an edge has the whole light on the lit side (`sign` 1) or on the
// other; if there is none, because the edge's line meets the light after all, the decided one.
// A corner on the line is in every plane.
RealVector touched_corner(const std::array<RealVector, 4>& corners, const RealVector& begin,
                          const RealVector& end, int sign, std::size_t decided) {
  const auto normal_by = [&](const RealVector& corner) {
    return cross(end - begin, begin - corner);
  };
  const auto is_on_line = [&](const RealVector& corner) {
    const double from_line = length_of(normal_by(corner)) / length_of(end - begin);
    return !(from_line > kOnLine * length_of(corner));
  };
  for (const RealVector& corner : corners) {
    if (is_on_line(corner)) continue;
    const RealVector normal = normal_by(corner);
    const bool touches = std::ranges::all_of(corners, [&](const RealVector& other) {
      return is_on_line(other) || Real(sign * dot(normal, other - corner)) <= 0;
    });
    if (touches) return corner;
  }
  return corners[decided];
}

Real slope(const JudgedPlane& plane, const RealVector& way) {
  const Real slope = abs(dot(plane.normal(), way));
  return slope < kLeastSlope ? Real(kLeastSlope) : slope;
}

// a · by_a over the sum of both, in [0, 1].
Real portion(const Real& a, const Real& by_a, const Real& b, const Real& by_b) {
  const Real part = a * by_a;
  const Real sum = part + b * by_b;
  return sum > 0 ? Real(part / sum) : Real(0.5);
}

}  // namespace

std::array<RealVector, 4> rectangle_corners(const Light& light) {
  const RealVector u(light.half_u);
  const RealVector v(light.half_v);
  const RealVector p = u + v;
  const RealVector q = u - v;
  return {Real(-1) * p, q, p, Real(-1) * q};
}

Real JudgedWedge::share(const JudgedPlace& place) const {
  for (const JudgedPlane& plane : planes_) {
    if (!plane.inside(place)) return 0;
  }
  std::array<Real, 4> distance;
  for (std::size_t i = 0; i < distance.size(); ++i) distance[i] = abs(planes_[i].value(place));
  // t_b / (t_f + t_b), where the way t to a plane is its distance over the slope.
  const auto seen = [&](std::size_t side) {
    return portion(distance[1], slopes_[side][0], distance[0], slopes_[side][1]);
  };
  const Real left = portion(distance[3], along_edge_[0], distance[2], along_edge_[1]);
  return left * seen(0) + (1 - left) * seen(1);
}

JudgedLoop::JudgedLoop(const Scene& scene, const LinearLoop& loop, const RealPlane& end)
    : end_(end) {
  const auto& positions = scene.objects[loop.object].mesh.positions;
  const RealVector centre(scene.light.centre);
  const std::size_t n = loop.vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const auto at = [&](std::size_t k) { return RealVector(positions[loop.vertices[k]]) - centre; };
    edges_.push_back(make_edge(scene.light, at(i), at((i + 1) % n), loop.corners[i]));
  }
  for (std::size_t i = 0; i < n; ++i) {
    corners_.push_back(make_corner(edges_[(i + n - 1) % n], edges_[i], loop.corners[i]));
  }
}

JudgedLoop::Edge JudgedLoop::make_edge(const Light& light, const RealVector& begin,
                                       const RealVector& end, const LinearCorner& decided) const {
  Edge edge{begin, end, direction(end - begin, 0.0).way, quad_normal({}, begin, end), {}, {}};
  for (std::size_t i = 0; i < 2; ++i) {
    const int sign = i == 0 ? 1 : -1;
    RealVector touched = Real(sign * Real(light.radius)) * edge.quad.way;
    double loss = edge.quad.loss;
    edge.from[i] = touched;
    if (light.shape == LightShape::rectangle) {
      const auto corners = rectangle_corners(light);
      touched = touched_corner(corners, begin, end, sign, decided.touched[i]);
      loss = 1.0;
    }
    const Direction normal = quad_normal(touched, begin, end);
    if (light.shape == LightShape::rectangle) {
      const RealVector chosen = rectangle_corners(light)[decided.touched[i]];
      const double off = std::abs(dot(normal.way, chosen - touched).convert_to<double>());
      edge.from[i] = off <= kTouching * length_of(touched) ? chosen : touched;
    }
    edge.normals[i] = i == 0 ? normal : reversed(normal);
    edge.normals[i].loss *= loss;
  }
  return edge;
}

JudgedLoop::Corner JudgedLoop::make_corner(const Edge& ending, const Edge& starting,
                                           const LinearCorner& decided) const {
  Corner corner;
  const RealVector& at = starting.begin;
  const Direction away = direction(at, 0.0);
  for (std::size_t i = 0; i < 2; ++i) {
    corner.lines[i] =
        decided.by_ray[i]
            ? direction(at - Real(0.5) * (ending.from[i] + starting.from[i]), length_of(at))
            : turned_to(across(ending.normals[i], starting.normals[i]), at);
  }
  const RealVector quads = ending.quad.way + starting.quad.way;
  switch (decided.side) {
    case SideNormal::of_lines:
      corner.side = across(corner.lines[0], corner.lines[1]);
      break;
    case SideNormal::of_quads:
      corner.side = across(away, {quads, ending.quad.loss + starting.quad.loss});
      break;
    case SideNormal::along_edge:
      corner.side = part_across(ending.begin - at, away);
      break;
  }
  switch (decided.sign) {
    case SideSign::of_ending:
      corner.side = turned_to(corner.side, ending.begin - at);
      break;
    case SideSign::of_starting:
      corner.side = turned_to(corner.side, at - starting.end);
      break;
    case SideSign::of_turn:
      corner.side = turned_to(corner.side, unit(ending.begin - at) - unit(starting.end - at));
      break;
    case SideSign::of_quads:
      corner.side = turned_to(corner.side, cross(quads, away.way));
      break;
    case SideSign::of_any_way:
      corner.side = turned_to(corner.side, RealVector(kAnyWay));
      break;
  }
  // Of opposite normals the middle is across their difference; which way does not matter.
  const RealVector difference = ending.quad.way - starting.quad.way;
  const RealVector middle =
      length_of(quads) > length_of(difference) ? quads : cross(away.way, difference);
  corner.across = decided.across_way ? across(corner.side, away) : part_across(middle, corner.side);
  return corner;
}

JudgedWedge JudgedLoop::wedge(std::size_t place, std::span<const SidedPlane> planes) const {
  const Edge& edge = edges_[place];
  const Corner& left = corners_[place];
  const Corner& right = corners_[next(place)];
  const std::array<Direction, kLinearPlanes> inward{edge.normals[0], edge.normals[1],
                                                    reversed(left.side), right.side,
                                                    Direction{end_.inward, 1.0}};
  const std::array<const RealVector*, kLinearPlanes> through{&edge.begin, &edge.begin, &edge.begin,
                                                             &edge.end, &end_.through};
  JudgedWedge wedge;
  for (std::size_t i = 0; i < kLinearPlanes; ++i) {
    wedge.planes_[i] = {inward[i].way, *through[i], planes[i].minus, inward[i].loss};
  }
  for (std::size_t i = 0; i < 2; ++i) {
    wedge.slopes_[0][i] = slope(wedge.planes_[i], left.across.way);
    wedge.slopes_[1][i] = slope(wedge.planes_[i], right.across.way);
    wedge.along_edge_[i] = slope(wedge.planes_[2 + i], edge.along);
  }
  return wedge;
}

// Where the ray or line of the front planes at an edge's begin meets the end plane.
RealVector JudgedLoop::far_corner(std::size_t place) const {
  const RealVector& at = edges_[place].begin;
  const RealVector& way = corners_[place].lines[0].way;
  return at + Real(dot(end_.inward, end_.through - at) / dot(end_.inward, way)) * way;
}

JudgedPlane JudgedLoop::umbra_plane(const UmbraSource& source, bool minus) const {
  const std::size_t place = source.edge.place;
  const Edge& edge = edges_[place];
  Direction inward = edge.normals[0];
  if (source.plane == UmbraPlane::near_half) {
    inward = reversed(quad_normal(far_corner(place), edge.begin, edge.end));
  } else if (source.plane == UmbraPlane::far_half) {
    inward = reversed(quad_normal(far_corner(next(place)), far_corner(place), edge.end));
  }
  if (source.turned) inward = reversed(inward);
  return {inward.way, edge.end, minus, inward.loss};
}

}  // namespace wedgesim::functional
