#pragma once

#include <cstdint>
#include <functional>
#include <span>
#include <vector>

#include "functional/raster/depth_tiles.h"
#include "functional/raster/screen_volume.h"

namespace wedgesim::functional {

/// What rasterizing volumes reads and writes, in words (of pixels).
struct VolumeAccesses {
  std::uint64_t z_reads = 0;
  std::uint64_t light_reads = 0;  // of light words, to be modified
  std::uint64_t light_writes = 0;
  std::uint64_t shares = 0;  // pixels that a wedge added its share to, once for all channels
  VolumeAccesses& operator+=(const VolumeAccesses& other);
};

/// Volumes ready to be drawn, in the order of drawing.
struct VolumeFrame {
  const DepthTiles& tiles;
  std::span<const ScreenSide> sides;
  bool cull = true;  // wedges by tiles; else every tile that a wedge's outline touches is visited
  /// The sides come group by group, and each group's shadow is merged into that of the groups
  /// before it as if half of the smaller lay in the larger (Paper IV, 5.1); else all shadows add
  /// up.
  bool merge_groups = false;
};

/// A row of tiles of one drawing: the light words of its pixels, channel by channel, each
/// (column, 64). The words start at 1; umbra polygons subtract and add 1, wedges their shares.
struct VolumeRow {
  int row = 0;
  std::vector<float> words;
  VolumeAccesses accesses;
  std::vector<float> merged;          // as words: what the groups merged so far hide
  std::vector<std::uint8_t> touched;  // columns that the group at hand has touched
};

/// Merges what the group at hand hides and sets its words back to 1.
void merge_group(const DepthTiles& tiles, VolumeRow& row);

/// Draws one row of tiles: draw_row_by of volume_simd.h, with the share that a wedge adds.
using DrawRow = std::function<void(const VolumeFrame& frame, VolumeRow& row)>;

/// What a frame's pixels got.
struct DrawnVolumes {
  std::vector<float> values;  // (channel, height, width); 1 for the sky
  VolumeAccesses accesses;
};

/// Draws all rows, by the tile rows in parallel; the result does not depend on the threads.
DrawnVolumes draw_volumes(const VolumeFrame& frame, const DrawRow& draw_row, int channels = 1);

}  // namespace wedgesim::functional
