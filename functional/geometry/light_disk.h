#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <optional>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A light as the D-buffer's paper has it: a circular disk (seed 002, section 2). Its own frame:
/// x and y in its plane in units of its radius, height along its normal in world units.
struct LightDisk {
  glm::dvec3 centre{0.0};
  glm::dvec3 normal{0.0};  // unit, towards what it lights
  glm::dvec3 u{0.0};       // unit, across the normal and across each other
  glm::dvec3 v{0.0};
  double radius = 0.0;

  double height(const glm::dvec3& p) const;
  /// A point of its rim.
  glm::dvec3 rim(double angle) const;
};

/// The disk for a light. A rectangle gets the disk of equal area in its plane: the paper does not
/// say which, and this one keeps the light's power and, on the average over directions, the width
/// of its penumbrae. A sphere gets the disk of its radius across the way to `towards`.
LightDisk disk_of(const Light& light, const glm::dvec3& towards);

/// How much of the disk is in front of a triangle (section 2.1, Eq. 1: by the points of the disk
/// nearest to its front and farthest from it).
enum class DiskFacing : std::uint8_t {
  none,        // none-frontfacing: no point of the disk
  back_belt,   // a silhouette face with the disk's centre behind it
  front_belt,  // a silhouette face with the centre in front of it
  all          // all-frontfacing
};
DiskFacing disk_facing(const LightDisk& disk, const std::array<glm::dvec3, 3>& triangle);
std::vector<DiskFacing> disk_facings(const LightDisk& disk, const Mesh& mesh);

/// The angles on the rim of the extrusion points of a directed edge with the lit side on its left:
/// where planes through it touch the disk (section 2.1).
struct ExtrusionAngles {
  double umbra = 0.0;     // p_u: the whole disk is on the caster's side of the plane
  double penumbra = 0.0;  // p_p: the whole disk is on the other side
};
/// None if the edge's line meets the disk, or the edge has no length.
std::optional<ExtrusionAngles> extrusion_angles(const LightDisk& disk, const glm::dvec3& begin,
                                                const glm::dvec3& end);

}  // namespace wedgesim::functional
