#pragma once

#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <optional>
#include <span>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Axis-aligned bounds, world units.
struct Bounds {
  glm::dvec3 low{1e300};
  glm::dvec3 high{-1e300};
  void grow(const glm::dvec3& p);
  double diagonal() const;
};
Bounds bounds_of(std::span<const Object> objects);

/// Where an end plane lies: beyond the lower or upper side of the bounds, across the light's plane
/// or the way from the light to the middle of the caster's vertices; or the latter at a fixed
/// length.
enum class EndSide {
  low_x,
  high_x,
  low_y,
  high_y,
  low_z,
  high_z,
  across_light,
  across_way,
  fixed_length
};

/// How far beyond the last receiver volumes end, of the diagonal of the receivers' bounds.
inline constexpr double kEndMargin = 2e-3;

/// Where the shadow and penumbra volumes of one caster end: a plane (n, d) with n·p + d ≥ 0 for
/// every point that can receive a shadow.
struct EndPlane {
  glm::dvec4 plane{0.0};
  EndSide side = EndSide::low_x;
  /// Whether a point is on the side of the volumes, off the plane.
  bool is_before(const glm::dvec3& p) const;
  /// Where the ray from `from` through `through` meets the plane.
  glm::dvec3 reach(const glm::dvec3& from, const glm::dvec3& through) const;
};

/// The points of a light that bound its penumbrae: the corners of a rectangle, the centre alone of
/// a point or a sphere (whose extent is added as an angle).
std::vector<glm::dvec3> light_corners(const Light& light);

/// Chooses the end plane of a caster: the side of the bounds of everything, a little outside, that
/// every ray from the light through the silhouette reaches soonest; else a plane across the light.
/// With a fixed length: across the direction to the caster, that far behind it.
/// \param bounds  of all that receives
/// \param length  world units, or none for automatic
/// \throws InputError if some ray reaches no such plane (the light touches or surrounds the caster)
EndPlane choose_end_plane(const Mesh& caster, const Silhouette& silhouette, const Light& light,
                          const Bounds& bounds, std::optional<double> length);

}  // namespace wedgesim::functional
