#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <utility>
#include <vector>

#include "functional/raster/clip.h"

namespace wedgesim::functional {

/// The pixels x_begin ≤ x < x_end of one row.
struct PixelSpan {
  int y = 0, x_begin = 0, x_end = 0;
};

/// The rows of a frame part in which a convex snapped polygon covers pixels, one after the other. A
/// pixel is covered iff its centre is inside by the integer edge functions; centres on a left or
/// top edge are inside, on a right or bottom edge outside, so polygons that share an edge share no
/// pixel and leave no gap. Either winding; area 0 covers nothing.
class Spans {
 public:
  /// \param polygon  points with integers x and y, 1/256 pixels
  template <typename Point, std::size_t points>
  Spans(std::span<const Point, points> polygon, int width, int y_begin, int y_end) : width_(width) {
    std::int64_t area = 0;
    int low = INT32_MAX;
    int high = INT32_MIN;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point& p = polygon[i];
      const Point& q = polygon[i + 1 < polygon.size() ? i + 1 : 0];
      area += std::int64_t{p.x} * q.y - std::int64_t{q.x} * p.y;
      low = std::min(low, p.y);
      high = std::max(high, p.y);
    }
    y_ = std::max(y_begin, first_centre(low));
    y_end_ = std::min(y_end, last_centre(high) + 1);
    if (area == 0 || y_ >= y_end_) {
      y_end_ = y_;
      return;
    }
    if (polygon.size() > few_.size()) many_.resize(polygon.size());
    sides_ = many_.empty() ? few_.data() : many_.data();
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Point* p = &polygon[i];
      const Point* q = &polygon[i + 1 < polygon.size() ? i + 1 : 0];
      if (area < 0) std::swap(p, q);
      add_side(*p, *q);
    }
  }
  Spans(const Spans&) = delete;
  Spans& operator=(const Spans&) = delete;

  /// \return whether there is another row; it is then in `span`
  bool next(PixelSpan& span) {
    while (y_ < y_end_) {
      std::int64_t begin = 0;
      std::int64_t end = width_;
      for (std::size_t i = 0; i < count_; ++i) {
        Side& side = sides_[i];
        // Of pixel centres 256·x + 128 the first that is not left of the side.
        const std::int64_t x = (side.base - side.quotient + 127) >> 8;
        if (side.left) {
          begin = std::max(begin, x);
        } else {
          end = std::min(end, x);
        }
        side.step();
      }
      const int y = y_++;
      if (begin < end) {
        span = {y, static_cast<int>(begin), static_cast<int>(end)};
        return true;
      }
    }
    return false;
  }

 private:
  // A side crosses the line of a row's centres, rounded up, at base − quotient: exact division, in
  // steps from row to row.
  struct Side {
    std::int64_t base, quotient, remainder, quotient_step, remainder_step, divisor;
    bool left;

    void step() {
      quotient += quotient_step;
      remainder += remainder_step;
      const bool carry = remainder >= divisor;
      quotient += carry ? 1 : 0;
      remainder -= carry ? divisor : 0;
    }
  };

  // Pixel rows by their centres at 256·y + 128.
  static int first_centre(int y) { return (y - 128 + 255) >> 8; }
  static int last_centre(int y) { return (y - 128) >> 8; }
  static std::int64_t floor_div(std::int64_t a, std::int64_t b) {
    const std::int64_t q = a / b;
    return q - (a % b < 0 ? 1 : 0);
  }

  template <typename Point>
  void add_side(const Point& p, const Point& q) {
    const std::int64_t dx = std::int64_t{q.x} - p.x;
    const std::int64_t dy = std::int64_t{q.y} - p.y;
    if (dy == 0) {
      // The rows begin and end at the polygon's; centres on a bottom edge alone are outside.
      if (dx < 0) y_end_ = std::min(y_end_, first_centre(p.y));
      return;
    }
    Side& side = sides_[count_++];
    side.left = dy < 0;
    side.base = p.x;
    side.divisor = side.left ? -dy : dy;
    const std::int64_t slope = side.left ? dx : -dx;
    const std::int64_t at_first = slope * (256 * std::int64_t{y_} + 128 - p.y);
    side.quotient = floor_div(at_first, side.divisor);
    side.remainder = at_first - side.quotient * side.divisor;
    side.quotient_step = floor_div(256 * slope, side.divisor);
    side.remainder_step = 256 * slope - side.quotient_step * side.divisor;
  }

  int width_;
  int y_ = 0;
  int y_end_ = 0;
  std::size_t count_ = 0;
  Side* sides_ = nullptr;
  std::array<Side, 8> few_;
  std::vector<Side> many_;
};

/// Calls row(y, x_begin, x_end) for every row of a frame part in which a convex snapped polygon
/// covers pixels (Spans).
template <typename Row>
void for_each_span(std::span<const SnappedPoint> polygon, int width, int y_begin, int y_end,
                   Row&& row) {
  Spans spans(polygon, width, y_begin, y_end);
  for (PixelSpan span; spans.next(span);) row(span.y, span.x_begin, span.x_end);
}

}  // namespace wedgesim::functional
