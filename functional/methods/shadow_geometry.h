#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <vector>

#include "functional/geometry/extent.h"
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
  bool exists() const { return object != traces::kNone; }
};

/// What the renderer knows of a wedge of the trace, in world and light space.
struct ShadowWedge {
  std::vector<SidedPlane> planes;   // those that decide, at most kMaxPlanes
  SidedPlane umbra_plane;           // of its umbra polygon, into the shadow
  glm::dvec3 begin{0.0}, end{0.0};  // the silhouette edge, world space
  EdgeSource source;                // coverage
  glm::dvec3 light_begin{0.0}, light_end{0.0};
  std::array<double, 6> factors{};    // linear
  std::array<glm::dvec3, 4> umbra{};  // the outline of its umbra polygon, world space
};

/// A silhouette edge of a light with extent that has no wedge in the trace, for whatever reason.
struct BareEdge {
  EdgeSource source;
  SidedPlane umbra_plane;               // as a wedge's
  SidedPlane end_plane;                 // inside: before the end of the volumes
  std::uint32_t umbra = traces::kNone;  // its umbra polygon in the trace
};

/// All shadow volumes of a frame: wedges[i] is the i-th wedge of the trace, umbra_planes[i] belongs
/// to its i-th umbra polygon.
struct ShadowGeometry {
  traces::fb::WedgeKind kind = traces::fb::WedgeKind_coverage;
  std::vector<ShadowWedge> wedges;
  std::vector<SidedPlane> umbra_planes;
  /// Of each umbra polygon in the plane through the light's centre and a silhouette edge: that
  /// edge, directed so that its quad_plane turns inward as the polygon's does; of others, none.
  std::vector<EdgeSource> umbra_edges;
  std::vector<BareEdge> bare_edges;  // coverage
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
