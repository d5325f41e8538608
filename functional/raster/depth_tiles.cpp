#include "functional/raster/depth_tiles.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>

#include "traces/depth.h"

namespace wedgesim::functional {

DepthTiles::DepthTiles(const DepthBuffer& depth)
    : width_(depth.width),
      height_(depth.height),
      columns_((width_ + kTile - 1) / kTile),
      rows_((height_ + kTile - 1) / kTile),
      tiles_(static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_)),
      depths_(kTilePixels * tiles_.size()) {
  tbb::parallel_for(0, rows_, [&](int row) {
    for (int column = 0; column < columns_; ++column) fill(depth, column, row);
  });
}

void DepthTiles::fill(const DepthBuffer& depth, int column, int row) {
  Tile& tile = tiles_[index(column, row)];
  tile.z_min = 2.0;
  tile.z_max = -1.0;
  std::array<double, kTilePixels> z{};
  const std::uint32_t sky = traces::sky_word(depth.format);
  const int x_end = std::min(kTile, width_ - kTile * column);
  const int y_end = std::min(kTile, height_ - kTile * row);
  for (int y = 0; y < y_end; ++y) {
    const std::size_t first =
        static_cast<std::size_t>(kTile * row + y) * static_cast<std::size_t>(width_) +
        static_cast<std::size_t>(kTile * column);
    for (int x = 0; x < x_end; ++x) {
      const std::uint32_t word = depth.words[first + static_cast<std::size_t>(x)];
      if (word == sky) continue;
      const auto pixel = static_cast<std::size_t>(kTile * y + x);
      z[pixel] = traces::decode_depth(depth.format, word);
      tile.surface |= std::uint64_t{1} << pixel;
      tile.z_min = std::min(tile.z_min, z[pixel]);
      tile.z_max = std::max(tile.z_max, z[pixel]);
    }
  }
  float* depths = depths_.data() + kTilePixels * index(column, row);
  for (std::size_t pixel = 0; pixel < kTilePixels; ++pixel) {
    const bool seen = (tile.surface >> pixel & 1U) != 0;
    depths[pixel] = seen ? static_cast<float>(z[pixel] - tile.z_min) : 0.0F;
  }
}

}  // namespace wedgesim::functional
