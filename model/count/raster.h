#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wedgesim::model {

/// A vertex snapped to 1/256 pixel.
struct Snapped {
  std::int64_t x = 0;
  std::int64_t y = 0;
};

/// Half-open range of pixels in a row; empty if begin == end.
struct Span {
  int begin = 0;
  int end = 0;
};

/// A convex snapped outline, ready for integer edge functions.
///
/// A pixel is covered iff its centre, (256x + 128, 256y + 128), is inside all edges; a centre on a
/// left or top edge is inside, on a right or bottom edge outside, so polygons that share an edge
/// share no pixel and leave no gap. Coordinates up to 2^28 in size.
class Outline {
 public:
  Outline() = default;
  explicit Outline(std::span<const Snapped> vertices);

  /// Seen counter-clockwise on the screen (y up), by the sign of the snapped area.
  bool eye_facing() const { return area_ < 0; }
  /// Area 0: covers nothing.
  bool empty() const { return area_ == 0; }
  /// Rows that may hold covered pixels; row_begin >= row_end if none.
  int row_begin() const { return row_begin_; }
  int row_end() const { return row_end_; }
  /// The covered pixels of a row, clipped to [0, width).
  Span row(int y, int width) const;
  /// Those of rows first_y ... first_y + 7, with one division an edge; none at or beyond height.
  std::array<Span, 8> rows(int first_y, int width, int height) const;
  bool covers(int x, int y) const;

 private:
  /// A left edge: X >= x - floor(k * (Y - y) / d); a right edge: X < that. d > 0.
  struct Edge {
    std::int64_t x, y, k, d;
    std::int64_t quotient, remainder;  // of 256 * k / d: the step from row to row
  };
  static void walk(const Edge& edge, int first_y, auto&& bound);
  void add_edge(const Snapped& p, const Snapped& q);

  std::vector<Edge> left_, right_;
  std::int64_t area_ = 0;  // doubled, y down
  int row_begin_ = 0;
  int row_end_ = 0;
};

}  // namespace wedgesim::model
