#pragma once

#include <cstdint>

namespace wedgesim::model::datapath {

/// A directed edge of a convex snapped outline whose inside lies clockwise of it on the screen (y
/// down): value = a x + b y + c in units of 1/256 x 1/256 pixel at the centre of pixel (x, y).
///
/// A pixel is covered iff no edge's value at its centre is negative. The top-left rule is part of
/// c: a centre on a left or top edge is inside, on another outside, so polygons that share an edge
/// share no pixel and leave none. Coordinates up to 2^28/256 pixels: values need 60 bits.
struct EdgeFunction {
  std::int64_t a = 0, b = 0, c = 0;

  /// \param x0, y0, x1, y1  ends, 1/256 pixel
  static EdgeFunction between(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) {
    const std::int64_t dx = x1 - x0;
    const std::int64_t dy = y1 - y0;
    const bool top_left = dy < 0 || (dy == 0 && dx > 0);
    // dx (Y - y0) - dy (X - x0) at X = 256 x + 128, Y = 256 y + 128
    return {-256 * dy, 256 * dx, dx * (128 - y0) - dy * (128 - x0) - (top_left ? 0 : 1)};
  }

  std::int64_t at(std::int64_t x, std::int64_t y) const { return a * x + b * y + c; }
  bool inside(std::int64_t x, std::int64_t y) const { return at(x, y) >= 0; }
  /// Is no pixel of [x0, x1) x [y0, y1) inside?
  bool misses(std::int64_t x0, std::int64_t y0, std::int64_t x1, std::int64_t y1) const {
    return !inside(a >= 0 ? x1 - 1 : x0, b >= 0 ? y1 - 1 : y0);
  }
};

}  // namespace wedgesim::model::datapath
