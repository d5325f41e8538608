#include "functional/geometry/linear_corner.h"

#include <algorithm>
#include <cmath>

#include "functional/raster/exact_cross.h"

namespace wedgesim::functional {
namespace {

// Side directions this far from the way of the light are replaced by a simpler construction.
constexpr double kLeastForward = 0.2;
// So are those that reach the end plane this many times farther away than a ray of the penumbra,
// or never: its inverse.
constexpr double kLeastReach = 0.01;
// The middle of the quads' normals has a direction in the side plane if so much of it is there.
constexpr double kLeastAcross = 1e-6;
// A side plane at an edge under less than this, or than the rounding of its own normal, does not
// say which side the edge is on.
constexpr double kInPlane = 1e-9;
constexpr double kLineRounding = 0x1p-50;

// A line that leads away from the light.
struct Line {
  glm::dvec3 from;    // a point near the light, relative to its centre
  glm::dvec3 way;     // unit
  double sine = 1.0;  // of the angle between the planes that meet in it
};

// The line in which two front (0) or back planes (1) meet, or a ray of the penumbra, which does
// reach the end plane, where that line hardly does or hardly leads away from the light (`by_ray`).
Line meeting(const CornerEdges& edges, std::size_t i, const EndPlane& end_plane, bool& by_ray) {
  const glm::dvec3 middle = 0.5 * (edges.ending.touch[i] + edges.starting.touch[i]);
  const Line ray{middle, glm::normalize(edges.at - middle)};
  const glm::dvec3 a(edges.ending.planes[i]), b(edges.starting.planes[i]);
  Line line;
  line.way = glm::cross(a, b);
  line.sine = glm::length(line.way);
  by_ray = true;
  if (line.sine < kLeastMeetingSine) return ray;
  line.way /= line.sine;
  // The point nearest to the centre, made from where the planes touch the light: however far the
  // edges go, it has the light's digits.
  line.from = (glm::dot(a, edges.ending.touch[i]) * glm::cross(b, line.way) +
               glm::dot(b, edges.starting.touch[i]) * glm::cross(line.way, a)) /
              line.sine;
  if (glm::dot(line.way, edges.at) < 0.0) line.way = -line.way;
  const glm::dvec3 down = -glm::dvec3(end_plane.plane);
  by_ray = glm::dot(line.way, edges.away()) < kLeastForward ||
           glm::dot(line.way, down) < kLeastReach * glm::dot(ray.way, down);
  return by_ray ? ray : line;
}

// Along the middle of two unit vectors across a way, or against it: the sum of opposite ones would
// be rounding.
glm::dvec3 middle_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& way) {
  const glm::dvec3 sum = a + b, difference = a - b;
  return glm::length(sum) > glm::length(difference) ? sum : glm::cross(way, difference);
}

// Which way is inward of a side plane of the lines, to the edge that ends here: the first of them
// whose part across the plane is more than rounding.
// \param rounding  by which the normal may be turned, in rad
glm::dvec3 inward_way(const CornerEdges& edges, const glm::dvec3& normal, double rounding,
                      SideSign& sign) {
  const glm::dvec3 to_ending = glm::normalize(edges.ending_begin - edges.at);
  const glm::dvec3 to_starting = glm::normalize(edges.starting_end - edges.at);
  const auto leaves_plane = [&](const glm::dvec3& way) {
    return std::abs(glm::dot(normal, way)) >= std::max(kInPlane, rounding);
  };
  sign = SideSign::of_ending;
  if (leaves_plane(to_ending)) return to_ending;
  sign = SideSign::of_starting;
  if (leaves_plane(to_starting)) return -to_starting;
  const auto is_sure = [&](const glm::dvec3& way) {
    return std::abs(glm::dot(normal, way)) > rounding * glm::length(way) + kLineRounding;
  };
  const glm::dvec3 turn = to_ending - to_starting;
  sign = SideSign::of_turn;
  if (is_sure(turn)) return turn;
  const glm::dvec3 quads = glm::cross(edges.ending.normal + edges.starting.normal, edges.away());
  sign = SideSign::of_quads;
  if (is_sure(quads)) return quads;
  sign = SideSign::of_any_way;
  return kAnyWay;
}

glm::dvec3 side_normal(const CornerEdges& edges, const Line& front, const Line& back,
                       LinearCorner& decided) {
  const auto& [ending, starting, at, ending_begin, starting_end] = edges;
  const glm::dvec3 away = edges.away();
  const double light_size =
      std::max({glm::length(ending.touch[0]), glm::length(ending.touch[1]),
                glm::length(starting.touch[0]), glm::length(starting.touch[1])});
  const glm::dvec3 of_lines = exact_cross({at, front.from}, {back.from, front.from});
  const double apart = glm::length(of_lines) / glm::distance(at, front.from);
  if (apart > kOneLine * light_size) {
    const glm::dvec3 normal = glm::normalize(of_lines);
    const double rounding = kLineRounding * light_size / (std::min(front.sine, back.sine) * apart);
    const glm::dvec3 inward = inward_way(edges, normal, rounding, decided.sign);
    return glm::dot(normal, inward) < 0.0 ? -normal : normal;
  }
  // This way round: seen from a sharp corner its edges are nearly in this plane, their side mostly
  // rounding.
  const glm::dvec3 of_quads = glm::cross(ending.normal + starting.normal, away);
  decided.side = SideNormal::of_quads;
  if (!(glm::length(of_quads) < 1e-9)) return glm::normalize(of_quads);
  decided.side = SideNormal::along_edge;  // the loop turns back along the edge
  const glm::dvec3 along = ending_begin - at;
  return glm::normalize(along - glm::dot(along, away) * away);
}

}  // namespace

CornerPlanes corner_between(const CornerEdges& edges, const glm::dvec3& light_centre,
                            const EndPlane& end_plane) {
  CornerPlanes corner;
  LinearCorner& decided = corner.decided;
  const glm::dvec3 away = edges.away();
  const Line front = meeting(edges, 0, end_plane, decided.by_ray[0]);
  const Line back = meeting(edges, 1, end_plane, decided.by_ray[1]);
  corner.front = front.way;
  const glm::dvec3 normal = side_normal(edges, front, back, decided);
  const double nearer = std::min(glm::length(edges.ending_begin), glm::length(edges.starting_end));
  const glm::dvec3 near_light = decided.side == SideNormal::of_lines ? front.from : glm::dvec3(0.0);
  const glm::dvec3 through = glm::length(edges.at) > kFarVertex * nearer ? near_light : edges.at;
  corner.side = glm::dvec4(normal, -glm::dot(normal, light_centre + through));
  const glm::dvec3 middle = middle_of(edges.ending.normal, edges.starting.normal, away);
  const glm::dvec3 across = middle - glm::dot(middle, normal) * normal;
  decided.across_way = !(glm::length(across) > kLeastAcross);
  corner.direction = glm::normalize(decided.across_way ? glm::cross(normal, away) : across);
  return corner;
}

}  // namespace wedgesim::functional
