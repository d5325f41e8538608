#include "model/count/raster.h"

#include <algorithm>

namespace wedgesim::model {
namespace {

constexpr std::int64_t kPixel = 256;
constexpr std::int64_t kCentre = 128;

std::int64_t floor_div(std::int64_t a, std::int64_t b) {  // b > 0
  return a / b - (a % b < 0 ? 1 : 0);
}

// The first pixel whose centre is at or beyond a coordinate.
std::int64_t first_pixel(std::int64_t coordinate) {
  return (coordinate - kCentre + kPixel - 1) >> 8;
}

}  // namespace

Outline::Outline(std::span<const Snapped> vertices) {
  if (vertices.size() < 3) return;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i < n; ++i) {
    const Snapped& p = vertices[i];
    const Snapped& q = vertices[(i + 1) % n];
    area_ += p.x * q.y - p.y * q.x;
  }
  if (area_ == 0) return;
  edges_.reserve(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Snapped& p = vertices[area_ > 0 ? i : (i + 1) % n];
    const Snapped& q = vertices[area_ > 0 ? (i + 1) % n : i];
    if (p.x != q.x || p.y != q.y) edges_.push_back({p.x, p.y, q.x - p.x, q.y - p.y});
  }
  const auto [low, high] =
      std::minmax_element(vertices.begin(), vertices.end(),
                          [](const Snapped& a, const Snapped& b) { return a.y < b.y; });
  row_begin_ = static_cast<int>(first_pixel(low->y));
  row_end_ = static_cast<int>(first_pixel(high->y));
}

Span Outline::row(int y, int width) const {
  const std::int64_t centre_y = kPixel * y + kCentre;
  std::int64_t begin = 0;
  std::int64_t end = width;
  for (const Edge& edge : edges_) {
    const std::int64_t e = edge.dx * (centre_y - edge.y);  // inside: e - dy*(X - x) > 0
    if (edge.dy < 0) {                                     // left: X >= x + ceil(-e / -dy)
      begin = std::max(begin, first_pixel(edge.x - floor_div(e, -edge.dy)));
    } else if (edge.dy > 0) {  // right: X < x + ceil(e / dy)
      end = std::min(end, first_pixel(edge.x - floor_div(-e, edge.dy)));
    } else if (edge.dx > 0 ? e < 0 : e <= 0) {  // above a top edge, or not above a bottom edge
      return {};
    }
  }
  if (begin >= end) return {};
  return {static_cast<int>(begin), static_cast<int>(end)};
}

bool Outline::covers(int x, int y) const {
  if (y < row_begin_ || y >= row_end_) return false;
  const Span span = row(y, x + 1);
  return span.begin <= x && x < span.end;
}

}  // namespace wedgesim::model
