#pragma once

#include <map>
#include <span>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <vector>

#include "functional/geometry/wedge.h"
#include "functional/raster/clip.h"
#include "functional/raster/window.h"
#include "traces/trace.h"

namespace wedgesim::functional {

/// Turns world-space volumes into the sections of a trace: snapped vertices and window planes, each
/// stored once, and the polygons over them.
class ScreenBuilder {
 public:
  ScreenBuilder(const Window& window, traces::Trace& trace) : window_(window), trace_(trace) {}

  /// The reference of a world plane (n, d). A plane and its opposite share one entry.
  std::uint32_t plane_reference(const glm::dvec4& world_plane);

  /// Adds an umbra polygon, clipped and snapped; one whose snapped outline is not convex becomes
  /// triangles, of which the largest alone belongs to the wedge; what covers nothing is left out.
  /// \param twisted  the outline may be wound against its plane, or be a figure of eight: each part
  ///                 takes the side of the plane that goes with the way it is wound
  /// \param plane  reference, or 0 for a cap
  /// \return its index, or traces::kNone if nothing of it is left
  std::uint32_t add_umbra_polygon(std::span<const glm::dvec3> outline, std::uint32_t plane,
                                  std::uint32_t wedge, std::uint32_t caster,
                                  traces::fb::UmbraRole role, bool twisted = false);

  /// Adds the faces of a wedge. Their outline on the screen is grown by up to 1/128 pixel, so that
  /// snapping never loses a pixel whose point is inside.
  /// \param wedge  gets faces, planes and z interval; other fields are kept
  /// \return false if nothing of it is in front of the eye
  bool add_faces(const WorldWedge& volume, traces::fb::Wedge& wedge);

 private:
  std::uint32_t vertex(const SnappedPoint& point);
  bool holds_near_corner(const WorldWedge& volume) const;
  bool is_turned(std::span<const SnappedPoint> outline, std::uint32_t reference) const;
  std::pair<std::uint32_t, std::uint32_t> add_outline(std::span<const SnappedPoint> outline);

  const Window& window_;
  traces::Trace& trace_;
  std::map<std::tuple<double, double, double, double>, std::uint32_t> planes_;
  struct Hash {
    std::size_t operator()(const SnappedPoint& p) const;
  };
  std::unordered_map<SnappedPoint, std::uint32_t, Hash> vertices_;
};

}  // namespace wedgesim::functional
