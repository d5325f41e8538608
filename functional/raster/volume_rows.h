#pragma once

#include <array>
#include <cstdint>

#include "functional/raster/depth_tiles.h"
#include "functional/raster/screen_volume.h"

namespace wedgesim::functional {

/// What a side may touch in one row of tiles.
struct SideRows {
  struct Span {
    int begin = 0;
    int end = 0;
    bool empty() const { return begin >= end; }
    bool holds(int i) const { return i >= begin && i < end; }
  };
  std::array<Span, kTile> umbra;  // pixels that its polygon covers, exactly, row by row
  Span umbra_tiles;
  Span wedge_tiles;
  std::array<Span, 2> half_tiles;  // of a wedge in halves
};

/// \param row  of tiles
/// \param umbra, wedge  whether polygon and wedge are wanted
SideRows side_rows(const ScreenSide& side, int width, int height, int row, bool umbra, bool wedge);

/// The smallest span that holds both.
SideRows::Span joined(SideRows::Span a, SideRows::Span b);

/// The pixels of a tile that the polygon covers.
std::uint64_t covered_pixels(const SideRows& rows, int column);

/// A window form at the middle of a tile and its nearest depth, and what lies around it.
struct FormRange {
  double middle, low, high;  // low ≤ form ≤ high at all pixel centres and depths of the tile
  double doubt;              // bounds the rounding of single precision in the tile
};
FormRange form_range(const WindowForm& form, int column, int row, const DepthTiles::Tile& tile);

/// Whether a wedge's planes show that none of its points is in a tile.
bool is_culled(const ScreenWedge& wedge, int column, int row, const DepthTiles::Tile& tile);

/// Whether the plane between the halves of a side's wedge shows that no point of one is in a tile.
/// \param inner  the half in the shadow
bool half_is_culled(const ScreenSide& side, bool inner, int column, int row,
                    const DepthTiles::Tile& tile);

}  // namespace wedgesim::functional
