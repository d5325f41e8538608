#pragma once

#include <algorithm>
#include <cstdint>
#include <span>
#include <utility>

#include "functional/raster/clip.h"

namespace wedgesim::functional {

/// Calls row(y, x_begin, x_end) for every row of a frame part in which a convex snapped polygon
/// covers pixels. A pixel is covered iff its centre is inside by the integer edge functions;
/// centres on a left or top edge are inside, on a right or bottom edge outside, so polygons that
/// share an edge share no pixel and leave no gap. Either winding; area 0 covers nothing.
template <typename Row>
void for_each_span(std::span<const SnappedPoint> polygon, int width, int y_begin, int y_end,
                   Row&& row) {
  const std::int64_t area = doubled_area(polygon);
  if (area == 0) return;
  const auto [low, high] =
      std::minmax_element(polygon.begin(), polygon.end(),
                          [](const SnappedPoint& a, const SnappedPoint& b) { return a.y < b.y; });
  // Centres at 256·y + 128.
  y_begin = std::max(y_begin, (low->y - 128 + 255) >> 8);
  y_end = std::min(y_end, ((high->y - 128) >> 8) + 1);
  const auto floor_div = [](std::int64_t a, std::int64_t b) {
    const std::int64_t q = a / b;
    return q - ((a % b != 0 && (a < 0) != (b < 0)) ? 1 : 0);
  };
  for (int y = y_begin; y < y_end; ++y) {
    const std::int64_t cy = 256 * std::int64_t{y} + 128;
    std::int64_t x_low = 0;
    std::int64_t x_high = width - 1;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const SnappedPoint* p = &polygon[i];
      const SnappedPoint* q = &polygon[i + 1 < polygon.size() ? i + 1 : 0];
      if (area < 0) std::swap(p, q);
      const std::int64_t dx = std::int64_t{q->x} - p->x;
      const std::int64_t dy = std::int64_t{q->y} - p->y;
      const std::int64_t e = dx * (cy - p->y);
      // Inside iff e − dy·(X − p.x) ≥ 0 (> 0 on right and bottom edges), X = 256·x + 128.
      if (dy < 0) {                                           // left edge: X ≥ p.x + e/dy
        const std::int64_t bound = p->x - floor_div(e, -dy);  // ceil(e/dy) = −floor(e/−dy)
        x_low = std::max(x_low, (bound - 128 + 255) >> 8);
      } else if (dy > 0) {  // right edge: X < p.x + e/dy
        const std::int64_t bound = p->x - floor_div(-e, dy) - 1;
        x_high = std::min(x_high, (bound - 128) >> 8);
      } else if (dx > 0 ? e < 0 : e <= 0) {
        if (dx != 0) x_high = -1;
      }
    }
    if (x_low <= x_high) row(y, static_cast<int>(x_low), static_cast<int>(x_high) + 1);
  }
}

}  // namespace wedgesim::functional
