#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functional/geometry/wedge.h"
#include "functional/methods/shadow_geometry.h"
#include "functional/raster/screen_volume.h"
#include "functional/raster/window.h"

namespace wedgesim::functional {

/// Puts polygons and wedges of volumes on the screen, as volume_raster.h draws them.
class ScreenSides {
 public:
  explicit ScreenSides(const Window& window) : window_(window) {}

  /// Adds an umbra polygon: the largest of the convex parts that its outline snaps into first, then
  /// the others; nothing if nothing of it is in view.
  /// \param plane  into the shadow; unused by a cap
  /// \param twisted  the outline may be wound against its plane, which then turns with it
  void add_umbra(std::span<const glm::dvec3> outline, const SidedPlane& plane,
                 traces::fb::UmbraRole role, bool twisted, std::vector<ScreenSide>& sides) const;

  /// Adds a wedge to sides[first], which is made if it is not there. A wedge out of view is left
  /// out.
  /// \return the wedge, still without forms, or nullptr
  ScreenWedge* add_wedge(const WorldWedge& volume, const SidedPlane& plane, std::size_t first,
                         std::vector<ScreenSide>& sides) const;

  /// Splits a wedge into its halves by the plane of its umbra polygon.
  void split_wedge(const WorldWedge& volume, const SidedPlane& plane, ScreenWedge& wedge) const;

  const Window& window() const { return window_; }

 private:
  void add_points(std::span<const glm::dvec3> polygon, std::vector<glm::dvec2>& points) const;
  ScreenSide bare_side(const SidedPlane& plane) const;

  const Window& window_;
};

/// Sets the group of the sides from `first` on.
void set_group(std::vector<ScreenSide>& sides, std::size_t first, std::uint32_t group);

}  // namespace wedgesim::functional
