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

/// May the polygon cover a pixel of the tile? What the tile walk asks: no edge leaves it out alone.
bool touches(const SetupPolygon& polygon, const PixelBox& tile);

}  // namespace wedgesim::model::units
