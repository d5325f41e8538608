#pragma once

#include <glm/vec2.hpp>
#include <glm/vec3.hpp>

#include "functional/geometry/grid_point.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The plane that receives, with axes of its own: x and y in it, z its height towards the light.
struct ReceiverPlane {
  glm::dvec3 origin{0.0};
  glm::dvec3 x_axis{0.0}, y_axis{0.0}, normal{0.0};  // orthonormal, right-handed
  double unit = 1.0;                                 // world length of a step of the grid

  glm::dvec3 from_world(const glm::dvec3& p) const;
  glm::dvec3 to_world(const glm::dvec2& p) const;
  /// The nearest point of the grid with even coordinates, which has to be within its limit.
  GridPoint vertex(const glm::dvec2& p) const;
  /// The nearest point of the grid; whether it is within its limit.
  bool locate(const glm::dvec2& p, GridPoint& point) const;
};

/// Receivers may leave their plane by this part of their extent.
inline constexpr double kPlaneTolerance = 1e-6;

/// The plane of all objects that cast nothing; its unit is not chosen yet.
/// \throws InputError if there are none, if they are not in one plane, or if it holds the light
ReceiverPlane find_receiver_plane(const Scene& scene);

}  // namespace wedgesim::functional
