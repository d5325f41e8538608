#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "functional/methods/light_depths.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A piece of a silhouette edge in the light's image with the penumbra on both sides of it. Of a
/// fragment at depth z the penumbra reaches scale · (1/z_near − 1/z) texels to either side: what
/// the occlusion camera's rays bend there at most.
struct PenumbraStrip {
  glm::vec2 begin{0.0F};    // texels
  glm::vec2 along{0.0F};    // unit, from begin to end
  float length = 0.0F;      // texels
  float near_begin = 0.0F;  // 1 / z_near at the ends
  float near_end = 0.0F;
  float far = 0.0F;    // z_far: of the surface behind the edge
  float scale = 0.0F;  // texels · world units
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t previous = kNone;  // the strip that ends where this one begins

  /// Unit, away from the caster.
  glm::vec2 outward() const { return {-along.y, along.x}; }
  float half_width(float inverse_near) const { return scale * (inverse_near - 1.0F / far); }
};

/// The strips of all casters whose edge the light's centre sees.
/// \param silhouettes  of each object from the light's centre; without loops of one that casts none
/// \param surfaces  of everything, as the light's centre sees it
/// \param radius    of the light, world units
/// Source: soft shadow occlusion camera, 3.2.1. The tuple it stores in every texel follows from
/// the strip. z_far is read beside the edge in the surfaces' depths.
std::vector<PenumbraStrip> penumbra_strips(const Scene& scene, const Window& light_window,
                                           std::span<const Silhouette> silhouettes,
                                           const LightDepths& surfaces, double radius);

}  // namespace wedgesim::functional
