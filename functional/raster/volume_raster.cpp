#include "functional/raster/volume_raster.h"

#include <tbb/parallel_for.h>

#include <algorithm>

namespace wedgesim::functional {
namespace {

// Copies a drawn row of tiles into the frame; the sky's pixels are 1.
void store(const DepthTiles& tiles, const VolumeRow& drawn, int channels,
           std::vector<float>& values) {
  const auto width = static_cast<std::size_t>(tiles.width());
  const auto height = static_cast<std::size_t>(tiles.height());
  const auto columns = static_cast<std::size_t>(tiles.columns());
  const int y_begin = kTile * drawn.row;
  const int y_end = std::min(tiles.height(), y_begin + kTile);
  for (std::size_t channel = 0; channel < static_cast<std::size_t>(channels); ++channel) {
    for (int y = y_begin; y < y_end; ++y) {
      float* out = values.data() + (channel * height + static_cast<std::size_t>(y)) * width;
      for (std::size_t x = 0; x < width; ++x) {
        const std::size_t pixel = kTile * static_cast<std::size_t>(y - y_begin) + x % kTile;
        const auto column = x / kTile;
        const bool seen =
            (tiles.tile(static_cast<int>(column), drawn.row).surface >> pixel & 1U) != 0;
        out[x] = seen ? drawn.words[(channel * columns + column) * kTilePixels + pixel] : 1.0F;
      }
    }
  }
}

}  // namespace

VolumeAccesses& VolumeAccesses::operator+=(const VolumeAccesses& other) {
  z_reads += other.z_reads;
  light_reads += other.light_reads;
  light_writes += other.light_writes;
  shares += other.shares;
  return *this;
}

DrawnVolumes draw_volumes(const VolumeFrame& frame, const DrawRow& draw_row, int channels) {
  const DepthTiles& tiles = frame.tiles;
  const auto pixels =
      static_cast<std::size_t>(tiles.width()) * static_cast<std::size_t>(tiles.height());
  DrawnVolumes drawn;
  drawn.values.resize(static_cast<std::size_t>(channels) * pixels);
  std::vector<VolumeAccesses> accesses(static_cast<std::size_t>(tiles.rows()));
  tbb::parallel_for(0, tiles.rows(), [&](int index) {
    VolumeRow row;
    row.row = index;
    row.words.assign(static_cast<std::size_t>(channels) *
                         static_cast<std::size_t>(tiles.columns()) * kTilePixels,
                     1.0F);
    draw_row(frame, row);
    store(tiles, row, channels, drawn.values);
    accesses[static_cast<std::size_t>(index)] = row.accesses;
  });
  for (const VolumeAccesses& row : accesses) drawn.accesses += row;
  return drawn;
}

}  // namespace wedgesim::functional
