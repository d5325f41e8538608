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
  const auto [low, high] =
      std::minmax_element(vertices.begin(), vertices.end(),
                          [](const Snapped& a, const Snapped& b) { return a.y < b.y; });
  row_begin_ = static_cast<int>(first_pixel(low->y));
  row_end_ = static_cast<int>(first_pixel(high->y));
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    add_edge(vertices[area_ > 0 ? i : next], vertices[area_ > 0 ? next : i]);
  }
}

// Inside: dx * (Y - y) - dy * (X - x) > 0.
void Outline::add_edge(const Snapped& p, const Snapped& q) {
  const std::int64_t dx = q.x - p.x;
  const std::int64_t dy = q.y - p.y;
  if (dy == 0) {
    // Rows above a top edge are outside, those below a bottom edge too.
    if (dx > 0) row_begin_ = std::max(row_begin_, static_cast<int>(first_pixel(p.y)));
    if (dx < 0) row_end_ = std::min(row_end_, static_cast<int>(first_pixel(p.y)));
    return;
  }
  const std::int64_t k = dy < 0 ? dx : -dx;
  const std::int64_t d = dy < 0 ? -dy : dy;
  const std::int64_t quotient = floor_div(kPixel * k, d);
  (dy < 0 ? left_ : right_).push_back({p.x, p.y, k, d, quotient, kPixel * k - quotient * d});
}

Span Outline::row(int y, int width) const {
  if (y < row_begin_ || y >= row_end_) return {};
  const std::int64_t centre_y = kPixel * y + kCentre;
  std::int64_t begin = 0;
  std::int64_t end = width;
  for (const Edge& edge : left_) {
    begin = std::max(begin, first_pixel(edge.x - floor_div(edge.k * (centre_y - edge.y), edge.d)));
  }
  for (const Edge& edge : right_) {
    end = std::min(end, first_pixel(edge.x - floor_div(edge.k * (centre_y - edge.y), edge.d)));
  }
  if (begin >= end) return {};
  return {static_cast<int>(begin), static_cast<int>(end)};
}

// Calls bound(i, x) for 8 rows: the first pixel whose centre is at or beyond an edge.
void Outline::walk(const Edge& edge, int first_y, auto&& bound) {
  const std::int64_t n = edge.k * (kPixel * first_y + kCentre - edge.y);
  std::int64_t quotient = floor_div(n, edge.d);
  std::int64_t remainder = n - quotient * edge.d;
  for (std::size_t i = 0; i < 8; ++i) {
    bound(i, first_pixel(edge.x - quotient));
    remainder += edge.remainder - edge.d;
    const std::int64_t borrow = remainder >> 63;  // all ones if negative; a branch would be a guess
    quotient += edge.quotient + 1 + borrow;
    remainder += edge.d & borrow;
  }
}

std::array<Span, 8> Outline::rows(int first_y, int width, int height) const {
  std::array<Span, 8> spans;
  const int first = std::max(row_begin_ - first_y, 0);
  const int last = std::min({row_end_ - first_y, height - first_y, 8});
  if (first >= last) return spans;
  std::array<std::int64_t, 8> begin{};
  std::array<std::int64_t, 8> end;
  end.fill(width);
  for (const Edge& edge : left_) {
    walk(edge, first_y, [&](std::size_t i, std::int64_t x) { begin[i] = std::max(begin[i], x); });
  }
  for (const Edge& edge : right_) {
    walk(edge, first_y, [&](std::size_t i, std::int64_t x) { end[i] = std::min(end[i], x); });
  }
  for (auto i = static_cast<std::size_t>(first); i < static_cast<std::size_t>(last); ++i) {
    if (begin[i] < end[i]) spans[i] = {static_cast<int>(begin[i]), static_cast<int>(end[i])};
  }
  return spans;
}

bool Outline::covers(int x, int y) const {
  const Span span = row(y, x + 1);
  return span.begin <= x && x < span.end;
}

}  // namespace wedgesim::model
