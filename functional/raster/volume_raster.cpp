#include "functional/raster/volume_raster.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <bit>

#include "base/check.h"

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

void merge_group(const DepthTiles& tiles, VolumeRow& row) {
  for (int column = 0; column < tiles.columns(); ++column) {
    const auto c = static_cast<std::size_t>(column);
    if (row.touched[c] == 0) continue;
    row.touched[c] = 0;
    for (std::size_t i = c * kTilePixels; i < (c + 1) * kTilePixels; ++i) {
      const float hidden = std::clamp(1.0F - row.words[i], 0.0F, 1.0F);
      const float before = row.merged[i];
      row.merged[i] = std::max(hidden, before) + 0.5F * std::min(hidden, before);
      row.words[i] = 1.0F;
    }
    const auto pixels =
        static_cast<std::uint64_t>(std::popcount(tiles.tile(column, row.row).surface));
    row.accesses.light_reads += 2 * pixels;
    row.accesses.light_writes += 2 * pixels;
  }
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
    if (frame.merge_groups) {
      CHECK_EQ(channels, 1);
      row.merged.assign(row.words.size(), 0.0F);
      row.touched.assign(static_cast<std::size_t>(tiles.columns()), 0);
    }
    draw_row(frame, row);
    if (frame.merge_groups) {
      merge_group(tiles, row);
      std::ranges::transform(row.merged, row.words.begin(),
                             [](float hidden) { return 1.0F - hidden; });
    }
    store(tiles, row, channels, drawn.values);
    accesses[static_cast<std::size_t>(index)] = row.accesses;
  });
  for (const VolumeAccesses& row : accesses) drawn.accesses += row;
  return drawn;
}

}  // namespace wedgesim::functional
