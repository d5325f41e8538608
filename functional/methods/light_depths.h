#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The nearest surfaces as a light's centre sees them, by 1/z with z the depth along its axis in
/// world units: linear across a triangle; 0 where nothing is.
class LightDepths {
 public:
  explicit LightDepths(int size)
      : size_(size),
        values_(std::make_unique_for_overwrite<float[]>(static_cast<std::size_t>(size) *
                                                        static_cast<std::size_t>(size))) {}
  int size() const { return size_; }
  float* row(int y) { return values_.get() + begin_of(y); }
  const float* row(int y) const { return values_.get() + begin_of(y); }
  float at(int x, int y) const { return row(y)[x]; }

 private:
  std::size_t begin_of(int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(size_);
  }
  int size_;
  std::unique_ptr<float[]> values_;
};

inline constexpr int kLightTile = 16;  // texels along an edge of a tile of the light's maps
/// Tiles along an edge of a map.
inline int light_tiles(int size) { return (size + kLightTile - 1) / kLightTile; }

/// The least and the greatest 1/z of a tile.
struct TileDepths {
  float least = 0.0F;
  float greatest = 0.0F;
};

/// What a light's centre sees of a scene.
struct ShadowMaps {
  LightDepths surfaces;  // casters and receivers, as they are
  /// Inside the first caster: a quarter of the way from its back to the nearest surface, so that
  /// neither a caster's lit side hides itself nor what touches its back is lit. (Woo's midpoint,
  /// nearer to the back, because steep sides need more room than contacts.)
  LightDepths casters;
  std::vector<TileDepths> caster_tiles;  // row by row
  std::uint64_t compared = 0;            // texels that were compared with a triangle
};

/// \param silhouettes  of each object from the light's centre
ShadowMaps draw_shadow_maps(const Scene& scene, std::span<const Silhouette> silhouettes,
                            const Window& light_window);

}  // namespace wedgesim::functional
