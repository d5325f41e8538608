#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// A wedge of Papers I and II: planes 0 front, 1 back, 2 left (at the edge's begin), 3 right, 4
/// bottom, then up to three that end it where its sides diverge; the umbra polygon is its front
/// face.
struct LinearWedge {
  glm::dvec3 begin, end;
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
/// those nearly parallel to the light's direction).
/// \param loop    the corners in order, world space
/// \param bounds  of the light and all that receives; wedges whose sides diverge end well outside
std::vector<LinearWedge> linear_wedges(const Light& light, std::vector<glm::dvec3> loop,
                                       const EndPlane& end_plane, const Bounds& bounds);

}  // namespace wedgesim::functional
