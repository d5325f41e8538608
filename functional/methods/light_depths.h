#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "functional/raster/light_map.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A map of surfaces as a light's centre sees them, by 1/z with z the depth along its axis in
/// world units: linear across a triangle; 0 where nothing is. Kept in blocks, as maps are drawn.
class LightDepths {
 public:
  explicit LightDepths(int size)
      : size_(size),
        columns_((size + kBlockEdge - 1) / kBlockEdge),
        values_(std::make_unique_for_overwrite<float[]>(
            static_cast<std::size_t>(columns_) * static_cast<std::size_t>(columns_) * kBlock)) {}
  int size() const { return size_; }
  int block_columns() const { return columns_; }
  /// The texels of a block, row by row; those beyond the map hold anything.
  float* block(int column, int row) { return values_.get() + begin_of(column, row); }
  const float* block(int column, int row) const { return values_.get() + begin_of(column, row); }
  float at(int x, int y) const {
    const auto column = static_cast<std::size_t>(x);
    const auto row = static_cast<std::size_t>(y);
    const std::size_t block =
        row / kBlockEdge * static_cast<std::size_t>(columns_) + column / kBlockEdge;
    return values_[block * kBlock + row % kBlockEdge * kBlockEdge + column % kBlockEdge];
  }

 private:
  std::size_t begin_of(int column, int row) const {
    return (static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
            static_cast<std::size_t>(column)) *
           kBlock;
  }
  int size_;
  int columns_;
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
  /// Where light ends: the nearest of the casters' fronts and, of what casts no shadow, of the
  /// farthest, as it does not keep the light from what is behind it.
  LightDepths surfaces;
  /// Inside the first caster: a quarter of the way from its back to its front, so that neither a
  /// caster's lit side hides itself nor what touches its back is lit. (Woo's midpoint, nearer to
  /// the back, because steep sides need more room than contacts.)
  LightDepths casters;
  std::vector<TileDepths> caster_tiles;  // row by row
  std::uint64_t compared = 0;            // texels that were compared with a triangle
};

/// \param silhouettes  of each object from the light's centre
ShadowMaps draw_shadow_maps(const Scene& scene, std::span<const Silhouette> silhouettes,
                            const Window& light_window);

}  // namespace wedgesim::functional
