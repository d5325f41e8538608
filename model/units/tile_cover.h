#pragma once

#include <cstdint>

#include "model/units/primitive_setup.h"

namespace wedgesim::model::units {

/// The part of a tile that lies in one 8x8 block of the frame: its pixels [x0, x1) x [y0, y1). A
/// set of them is one word, bit 8 * (y % 8) + x % 8.
struct BlockPart {
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;

  int bx() const { return x0 / 8; }
  int by() const { return y0 / 8; }
};

inline int bit_of(int x, int y) { return 8 * (y % 8) + x % 8; }

/// The pixels of a part that a polygon covers.
std::uint64_t covered(const SetupPolygon& polygon, const BlockPart& part);

/// Tiles [first, end) of a row.
struct TileSpan {
  int first = 0, end = 0;
  bool empty() const { return first >= end; }
  bool holds(int tx) const { return first <= tx && tx < end; }
};

/// The tiles of a row that the tile walk steps over: in which the polygon may cover a pixel, as no
/// edge leaves the tile out alone.
/// \param row   pixels of the row: the frame's whole width
/// \param tile  its tiles' edge, pixels
TileSpan touched(const SetupPolygon& polygon, const PixelBox& row, int tile);

}  // namespace wedgesim::model::units
