#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/geometry/linear_wedge.h"
#include "functional/geometry/wedge.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"
#include "traces/trace.h"

namespace wedgesim::functional {

/// A world plane with the tie rule of a trace: inside iff (n·p + d ≥ 0) differs from minus.
struct SidedPlane {
  glm::dvec4 plane{0.0};
  bool minus = false;
  SidedPlane() = default;
  explicit SidedPlane(const glm::dvec4& oriented);
  bool inside(const glm::dvec3& p) const;
};

/// A directed silhouette edge by what it is made of: an object of the scene and two vertices of its
/// mesh. Without an object where there is no such edge.
struct EdgeSource {
  std::uint32_t object = traces::kNone;
  std::uint32_t begin = 0, end = 0;
  std::uint32_t loop = 0, place = 0;  // linear: of ShadowGeometry::linear_loops, and its corners
  bool exists() const { return object != traces::kNone; }
};

/// What the renderer knows of a wedge of the trace, in world and light space.
struct ShadowWedge {
  std::vector<SidedPlane> planes;   // those that decide, at most kMaxPlanes
  SidedPlane umbra_plane;           // of its umbra polygon, into the shadow
  glm::dvec3 begin{0.0}, end{0.0};  // the silhouette edge, world space
  EdgeSource source;
  glm::dvec3 light_begin{0.0}, light_end{0.0};
  std::array<double, 6> factors{};    // linear
  std::array<glm::dvec3, 4> umbra{};  // the outline of its umbra polygon, world space
};

/// A silhouette edge of a light with extent that has no wedge in the trace, for whatever reason.
struct BareEdge {
  EdgeSource source;
  SidedPlane umbra_plane;               // as a wedge's
  std::vector<SidedPlane> planes;       // linear: the wedge's five; coverage: its end plane alone
  std::uint32_t umbra = traces::kNone;  // its umbra polygon in the trace
};

/// What the plane of an umbra polygon goes through: nothing (a cap); the light's centre and an
/// edge; an edge and the point of the light that a linear wedge's front plane touches; where that
/// face is bent, its edge and the far corner at the edge's begin, or the edge's end and both far
/// corners; or the end plane.
enum class UmbraPlane { none, quad, front, near_half, far_half, end };

/// What an umbra polygon is made from.
struct UmbraSource {
  UmbraPlane plane = UmbraPlane::none;
  EdgeSource edge;      // of an end plane the object alone
  bool turned = false;  // the plane's inside is the other one
};

/// A silhouette loop of a `linear` frame: the vertices that edges are kept between, in order, and
/// what was decided there.
struct LinearLoop {
  std::uint32_t object = 0;  // of the scene
  std::vector<std::uint32_t> vertices;
  std::vector<LinearCorner> corners;
};

/// All shadow volumes of a frame: wedges[i] is the i-th wedge of the trace, umbra_planes[i] belongs
/// to its i-th umbra polygon.
struct ShadowGeometry {
  traces::fb::WedgeKind kind = traces::fb::WedgeKind_coverage;
  std::vector<ShadowWedge> wedges;
  std::vector<SidedPlane> umbra_planes;
  std::vector<UmbraSource> umbra_sources;  // of each umbra polygon
  std::vector<BareEdge> bare_edges;
  std::vector<LinearLoop> linear_loops;
  std::vector<EndSide> end_sides;  // of each object of the scene; only of casters with a silhouette
  /// The light-facing triangles of all casters, world space.
  std::vector<std::array<glm::dvec3, 3>> caps;
  std::size_t degenerate_wedges = 0;  // edges whose wedge holds nothing
};

/// Builds the volumes of every caster of a scene and fills the trace's vertices, planes, faces,
/// wedges, umbra polygons and casters.
/// \param length  fixed length of the volumes, world units; none: just beyond the receivers
/// \param receivers  bounds of all that receives shadows
/// \throws InputError if the light touches a caster or its penumbra spans a half-space
ShadowGeometry build_shadow_geometry(const Scene& scene, const Window& window,
                                     traces::fb::WedgeKind kind, std::optional<double> length,
                                     const Bounds& receivers, traces::Trace& trace);

}  // namespace wedgesim::functional
