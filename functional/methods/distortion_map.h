#pragma once

#include <array>
#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "functional/methods/penumbra_strips.h"
#include "functional/methods/strip_splats.h"

namespace wedgesim::functional {

/// Texels of the light's image, each with the nearest silhouette whose penumbra holds it: those
/// outside of the silhouette in one map, those inside in the other, or all in one.
/// Source: soft shadow occlusion camera, 3.2.1 and 4. The map is kept in tiles, and only tiles that
/// hold a strip are ever touched: `holds` is the cheap look that says so.
class DistortionMap {
 public:
  /// \param size  texels along an edge of the light's image
  /// \param maps  2: outside and inside; 1: one for both
  DistortionMap(std::span<const PenumbraStrip> strips, int size, int maps);

  int size() const { return size_; }
  int maps() const { return maps_; }
  /// Whether any strip may be near a texel, in any map.
  bool holds(int x, int y) const { return used_[tile_of(x, y)] != 0; }
  /// \return the nearest strip at a texel, if any; in one map whatever the side
  StripName at(bool inside, int x, int y) const {
    const std::size_t map = maps_ == 2 && inside ? 1 : 0;
    const std::size_t tile = tile_of(x, y);
    if ((used_[tile] & (1U << map)) == 0) return {};
    return {texels_[map][tile].name[texel_of(x, y)]};
  }
  /// Texels that were compared with a strip; each is read, and written if it is nearer.
  std::uint64_t compared() const { return compared_; }
  std::uint64_t written() const { return written_; }

 private:
  struct Tile {
    std::array<float, kLightTile * kLightTile> distance;
    std::array<std::uint32_t, kLightTile * kLightTile> name;
  };
  struct Count {
    std::uint64_t compared = 0, written = 0;
  };

  std::size_t tile_of(int x, int y) const {
    return static_cast<std::size_t>(y) / kLightTile * tiles_ +
           static_cast<std::size_t>(x) / kLightTile;
  }
  static std::size_t texel_of(int x, int y) {
    return static_cast<std::size_t>(y) % kLightTile * kLightTile +
           static_cast<std::size_t>(x) % kLightTile;
  }
  Tile& touch(std::size_t map, int x, int y);
  Count draw(const StripSplat& splat, const PenumbraStrip& strip, int y_begin, int y_end);

  int size_;
  int maps_;
  std::size_t tiles_;  // along an edge
  std::array<std::unique_ptr<Tile[]>, 2> texels_;
  std::vector<std::uint8_t> used_;  // of each tile, a bit a map
  std::uint64_t compared_ = 0;
  std::uint64_t written_ = 0;
};

}  // namespace wedgesim::functional
