#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <vector>

#include "functional/raster/depth_buffer.h"

namespace wedgesim::functional {

/// Tiles of this many pixels a side; a tile's pixels are numbered row by row, 0…63.
inline constexpr int kTile = 8;
inline constexpr std::size_t kTilePixels = 64;

/// The eye's depth buffer as the fast volume methods read it: tile by tile, each depth from its
/// tile's nearest, so that single precision keeps what the format holds.
class DepthTiles {
 public:
  struct Tile {
    double z_min = 0.0;  // of the surfaces seen
    double z_max = 0.0;
    std::uint64_t surface = 0;  // pixels that show a surface: not the sky, not beyond the frame
  };

  explicit DepthTiles(const DepthBuffer& depth);

  int width() const { return width_; }
  int height() const { return height_; }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  const Tile& tile(int column, int row) const { return tiles_[index(column, row)]; }
  /// 64 depths less the tile's z_min; 0 where no surface is seen.
  const float* depths(int column, int row) const {
    return depths_.data() + kTilePixels * index(column, row);
  }

 private:
  std::size_t index(int column, int row) const {
    return static_cast<std::size_t>(row) * static_cast<std::size_t>(columns_) +
           static_cast<std::size_t>(column);
  }
  void fill(const DepthBuffer& depth, int column, int row);

  int width_, height_, columns_, rows_;
  std::vector<Tile> tiles_;
  std::vector<float> depths_;
};

}  // namespace wedgesim::functional
