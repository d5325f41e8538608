#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// One face of a wedge: the corners of its outline, counter-clockwise seen from outside, and the
/// plane it lies in.
struct WedgeFace {
  std::uint32_t plane = 0;             // into WorldWedge::planes
  std::vector<std::uint32_t> corners;  // into WorldWedge::vertices
};

/// A penumbra wedge in world space: a convex volume that holds every point from which a silhouette
/// edge covers a part of the light, ended by a plane beyond all receivers.
struct WorldWedge {
  /// (n, d): inside iff n·p + d ≥ 0; at most kMaxPlanes of them decide, the rest bound faces only.
  std::vector<glm::dvec4> planes;
  std::vector<glm::dvec3> vertices;
  std::vector<WedgeFace> faces;
};
inline constexpr std::size_t kMaxPlanes = 8;

/// The plane of the shadow quad of a directed silhouette edge: through the light's centre and the
/// edge, n·p + d ≥ 0 on the side of the shadow.
glm::dvec4 quad_plane(const glm::dvec3& light_centre, const glm::dvec3& begin,
                      const glm::dvec3& end);

/// Builds the tightest wedge of an edge whose sides are planes that touch both the edge and the
/// light. A plane with the edge on one side and the light on the other has the penumbra on the
/// edge's side, so every such plane bounds it; for a rectangle all of them that matter are taken
/// (6, the tighter wedges of Paper IV, 4.1), for a sphere 6 around it. Differs from Paper III, 3.1:
/// the end farther from the light is not moved towards it, which this argument makes unnecessary.
/// \return a wedge without planes if the edge has no length and no extent (nothing to rasterize)
WorldWedge coverage_wedge(const Light& light, const glm::dvec3& begin, const glm::dvec3& end,
                          const EndPlane& end_plane);

/// The outlines of a wedge's faces on one side of a plane, n·p + d ≥ 0; the face that closes this
/// part lies in the plane and has no corners of its own.
std::vector<std::vector<glm::dvec3>> faces_inside(const WorldWedge& wedge, const glm::dvec4& plane);

}  // namespace wedgesim::functional
