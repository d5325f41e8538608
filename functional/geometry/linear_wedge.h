#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// Which normal a side plane has: of the lines, or rays, in which the front and the back planes of
/// two edges meet; where these are one (kOneLine), of the light's way and the middle of the quads'
/// normals; where a loop turns back along its edge, along that edge and across the light's way.
enum class SideNormal { of_lines, of_quads, along_edge };
/// What says which side of a side plane of_lines is whose: the edge that ends at the corner; where
/// that is in the plane, the one that starts there; where both are, the turn from one's direction
/// to the other's; where that is rounding, the middle of the quads' normals; where that is, too,
/// nothing does, and kAnyWay stands for it.
enum class SideSign { of_ending, of_starting, of_turn, of_quads, of_any_way };

/// A corner of a rectangle this near to an edge's line, of its way from the centre, is on it.
inline constexpr double kOnLine = 1e-10;
/// Front planes, or back planes, of neighbours at an angle of less than this sine meet in no line.
inline constexpr double kLeastMeetingSine = 1e-6;
/// Along no axis and in no plane that scenes are likely to have.
inline constexpr glm::dvec3 kAnyWay{0.7351, 0.5247, 0.4292};
/// Two lines of meeting nearer to one another than this part of the light's size are one.
inline constexpr double kOneLine = 1e-9;
/// A vertex more than this many times as far from the light as a neighbour has its side plane go
/// through a point near the light, not through itself.
inline constexpr double kFarVertex = 16.0;

/// What is decided by comparing at the corner where an edge begins. Geometry follows from it.
struct LinearCorner {
  std::size_t place = 0;  // in the loop as given
  /// The edge's front and back plane each touch this one of light_corners; 0 of a sphere.
  std::array<std::size_t, 2> touched{};
  /// Front planes, and back planes, meet too far aside: a ray of the penumbra is in their place.
  std::array<bool, 2> by_ray{};
  SideNormal side = SideNormal::of_lines;
  SideSign sign = SideSign::of_ending;
  /// The middle of the quads' normals has no direction in the side plane: that across the light's
  /// way is in its place.
  bool across_way = false;
};

inline constexpr std::size_t kLinearPlanes = 5;
/// A way along which a plane comes nearer more slowly than this counts as if it did so.
inline constexpr double kLeastSlope = 1e-12;

/// A wedge of Papers I and II: planes 0 front, 1 back, 2 left (at the edge's begin), 3 right, 4
/// bottom, then up to three that end it where its sides diverge; the umbra polygon is its front
/// face.
struct LinearWedge {
  glm::dvec3 begin, end;
  LinearCorner corner;  // at `begin`
  WorldWedge volume;
  /// The outline of the umbra polygon, counter-clockwise seen from outside the shadow; corners
  /// are shared with the neighbours bit for bit.
  std::array<glm::dvec3, 4> umbra;
  /// What turns plane values (n·p + d) into the distances of Paper I, Eqs. 2 and 3: front and back
  /// along the left direction, front and back along the right direction, left and right along the
  /// edge.
  std::array<double, 6> factors;
};

/// The wedges of one silhouette loop. The front plane leaves the light on the lit side, the back
/// plane on the other: they pass through the points of the sphere along the normal of the shadow
/// quad (Paper I, 4.1), or touch opposite corners of a rectangle (Paper I, 8). Neighbours share a
/// side plane through the intersections of their front and of their back planes. Edges whose line
/// meets the light, through which no such planes pass, are left out, their ends joined (Paper I, 8:
/// those nearly parallel to the light's direction); so are those whose line passes the light's
/// centre at less than 1e-3 of the way to their nearer end, of whatever light, and those shorter
/// than 1e-10 of that way, whose direction is rounding.
/// \param loop    the corners in order, world space
/// \param bounds  of the light and all that receives; wedges whose sides diverge end well outside
std::vector<LinearWedge> linear_wedges(const Light& light, std::vector<glm::dvec3> loop,
                                       const EndPlane& end_plane, const Bounds& bounds);

}  // namespace wedgesim::functional
