#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Depths of the nearest surfaces as the light's centre sees them, world units along its axis;
/// infinite where there is none.
struct LightDepths {
  int size = 0;
  std::vector<float> values;  // (size, size)
  float at(int x, int y) const {
    return values[static_cast<std::size_t>(y) * static_cast<std::size_t>(size) +
                  static_cast<std::size_t>(x)];
  }
};

/// What a light's centre sees of a scene.
struct ShadowMaps {
  LightDepths surfaces;  // casters and receivers, as they are
  /// Casters alone, each texel as far as its triangle's plane is anywhere within a texel of its
  /// centre, so that no fragment that looks there hides itself.
  LightDepths casters;
  std::uint64_t compared = 0;  // texels that were compared with a triangle
};

ShadowMaps draw_shadow_maps(const Scene& scene, const Window& light_window);

}  // namespace wedgesim::functional
