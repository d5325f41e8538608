#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>
#include <span>

#include "functional/geometry/wedge.h"
#include "functional/raster/window.h"

namespace wedgesim::functional {

/// The pyramid from the eye to the near rectangle. Where it meets a shadow volume, z-pass counts
/// wrong: a face of the volume is cut away between the eye and what it sees.
class NearPyramid {
 public:
  explicit NearPyramid(const Window& window);

  /// False only if a plane of one has all of the other behind it, so true may be too careful.
  bool may_meet(const WorldWedge& volume) const;
  /// Whether a part of a convex polygon is inside.
  bool meets(std::span<const glm::dvec3> polygon) const;
  const glm::dvec3& eye() const { return corners_[0]; }

 private:
  std::array<glm::dvec3, 5> corners_;
  std::array<glm::dvec4, 5> planes_;  // inside iff n·p + d ≥ 0
};

}  // namespace wedgesim::functional
