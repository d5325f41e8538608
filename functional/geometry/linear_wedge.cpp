#include "functional/geometry/linear_wedge.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numeric>

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
// Side directions this far from the way of the light are replaced by a simpler construction.
constexpr double kLeastForward = 0.2;
// So are those that reach the end plane this many times farther away than a ray of the penumbra,
// or never: its inverse.
constexpr double kLeastReach = 0.01;
// A side plane at an edge under less than this, or than the rounding of its own normal, does not
// say which side the edge is on.
constexpr double kInPlane = 1e-9;
constexpr double kLineRounding = 0x1p-50;
// Between a front and a back plane that face one another at less than this angle there is nothing.
constexpr double kFlat = 0x1p-50;
// How far a wedge whose sides diverge may go, in diagonals of all that receives.
constexpr double kLidRadius = 4.0;

// Of an edge: its front plane, then its back plane.
struct EdgePlanes {
  glm::dvec3 normal;                     // of the shadow quad, unit, into the shadow
  std::array<std::size_t, 2> touched{};  // of light_corners
  std::array<glm::dvec3, 2> touch;       // points of the light, relative to its centre
  std::array<glm::dvec4, 2> planes;      // unit normals, into the wedge
};

// The corner of a rectangle whose plane through the edge leaves the others on one side: the best of
// the four. Where the edge's line goes through a corner, the plane has the next one, too.
std::size_t touched_corner(const Light& light, const glm::dvec3& edge_begin,
                           const glm::dvec3& edge_end, double sign) {
  const std::vector<glm::dvec3> corners = light_corners(light);
  std::size_t best = 0;
  double best_beyond = 1e300;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3& corner = corners[i];
    const glm::dvec3 n = sign * glm::cross(edge_end - corner, edge_begin - corner);
    const double length = glm::length(n);
    const double from_line = length / glm::distance(edge_begin, edge_end);
    if (!(from_line > kOnLine * glm::distance(corner, light.centre))) continue;
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
      planes.touched[i] = touched_corner(light, begin, end, sign);
      Light about_centre = light;
      about_centre.centre = glm::dvec3(0.0);
      planes.touch[i] = light_corners(about_centre)[planes.touched[i]];
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

// A line that leads away from the light.
struct Line {
  glm::dvec3 from;    // a point near the light, relative to its centre
  glm::dvec3 way;     // unit
  double sine = 1.0;  // of the angle between the planes that meet in it
};

// One corner of the loop: the directions in which the front and back planes of its two edges meet,
// and the side plane through both, with the edge that ends here on its positive side.
struct Corner {
  LinearCorner decided;
  glm::dvec3 front;  // direction
  glm::dvec4 side;
  glm::dvec3 direction;  // in the side plane, across the penumbra (Paper I, 4.1)
};

// The edges at a corner, and where they are.
struct CornerEdges {
  const EdgePlanes& ending;
  const EdgePlanes& starting;
  glm::dvec3 at;  // from the light's centre, as the others
  glm::dvec3 ending_begin, starting_end;
  glm::dvec3 away() const { return glm::normalize(at); }
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

Corner corner_between(const CornerEdges& edges, const glm::dvec3& light_centre,
                      const EndPlane& end_plane) {
  Corner corner;
  const auto& [ending, starting, at, ending_begin, starting_end] = edges;
  const glm::dvec3 away = edges.away();
  const Line front = meeting(edges, 0, end_plane, corner.decided.by_ray[0]);
  const Line back = meeting(edges, 1, end_plane, corner.decided.by_ray[1]);
  corner.front = front.way;
  glm::dvec3 through = front.from;
  glm::dvec3 normal = exact_cross({at, front.from}, {back.from, front.from});
  const double apart = glm::length(normal) / glm::distance(at, front.from);
  const double light_size =
      std::max({glm::length(ending.touch[0]), glm::length(ending.touch[1]),
                glm::length(starting.touch[0]), glm::length(starting.touch[1])});
  if (!(apart > kOneLine * light_size)) {
    corner.decided.side = SideNormal::of_quads;
    // This way round: seen from a sharp corner its edges are nearly in this plane, their side
    // mostly rounding.
    through = glm::dvec3(0.0);
    normal = glm::cross(ending.normal + starting.normal, away);
    if (glm::length(normal) < 1e-9) {  // the loop turns back along the edge
      corner.decided.side = SideNormal::along_edge;
      normal = ending_begin - at;
      normal -= glm::dot(normal, away) * away;
    }
  }
  normal = glm::normalize(normal);
  if (corner.decided.side == SideNormal::of_lines) {
    const double rounding = kLineRounding * light_size / (std::min(front.sine, back.sine) * apart);
    const double least = std::max(kInPlane, rounding);
    const double to_ending = glm::dot(normal, glm::normalize(ending_begin - at));
    const double to_starting = glm::dot(normal, glm::normalize(starting_end - at));
    double inward = to_ending;
    if (std::abs(to_ending) < least) {
      corner.decided.sign =
          std::abs(to_starting) < least ? SideSign::of_both : SideSign::of_starting;
      inward = corner.decided.sign == SideSign::of_both
                   ? glm::dot(normal, ending_begin - starting_end)
                   : -to_starting;
    }
    if (inward < 0.0) normal = -normal;
  }
  const double nearer = std::min(glm::length(ending_begin), glm::length(starting_end));
  if (glm::length(at) <= kFarVertex * nearer) through = at;
  corner.side = glm::dvec4(normal, -glm::dot(normal, light_centre + through));
  const glm::dvec3 across = ending.normal + starting.normal;
  corner.direction = across - glm::dot(across, normal) * normal;
  const double length = glm::length(corner.direction);
  corner.decided.across_way = !(length > 1e-9);
  corner.direction = corner.decided.across_way ? glm::normalize(glm::cross(normal, away))
                                               : corner.direction / length;
  return corner;
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
  std::vector<Corner> corners;  // at the begin of edge i
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
    const Corner& left = corners[i];
    const Corner& right = corners[next];
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
    wedge.volume = intersect_half_spaces(sides, box);
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
