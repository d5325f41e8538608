#pragma once

#include <glm/vec3.hpp>

#include "functional/scene/scene.h"

namespace wedgesim::reports::stress {

/// The penumbra of an edge, cut across it: directions from the edge's middle in the plane of
/// `to_light` and `into_shadow`, unit vectors. Seen from there the light spans the angles from
/// `least`, below 0, to `most`, positive towards the shadow.
struct Penumbra {
  glm::dvec3 middle, to_light, into_shadow;
  double least, most;

  /// Unit vector towards the part of the light at an angle.
  glm::dvec3 towards(double angle) const;
  /// Unit vector across the plane through the edge and that part of the light, into the shadow.
  glm::dvec3 normal(double angle) const;
};

/// \param shadow  a point on the shadow's side of the plane through the edge and the light's centre
Penumbra penumbra_of(const functional::Light& light, const glm::dvec3& begin, const glm::dvec3& end,
                     const glm::dvec3& shadow);

}  // namespace wedgesim::reports::stress
