#include "model/units/tile_cover.h"

#include <algorithm>
#include <cstdlib>

namespace wedgesim::model::units {

namespace {

using datapath::EdgeFunction;

// Four rows of a block, side by side in a vector register.
using Rows [[gnu::vector_size(16)]] = std::int32_t;

// The pixels of a block that are outside an edge; \p value is that of the first.
std::uint64_t outside_rows(std::int32_t value, std::int32_t a, std::int32_t b) {
  // From the last column to the first, each row's signs are shifted in.
  Rows upper = Rows{0, b, 2 * b, 3 * b} + (value + 7 * a);
  Rows lower = upper + 4 * b;
  Rows upper_bits{};
  Rows lower_bits{};
  for (int x = 0; x < 8; ++x) {
    upper_bits += upper_bits - (upper >> 31);
    lower_bits += lower_bits - (lower >> 31);
    upper -= a;
    lower -= a;
  }
  std::uint64_t set = 0;
  for (int y = 0; y < 4; ++y) {
    set |= static_cast<std::uint64_t>(upper_bits[y]) << (8 * y);
    set |= static_cast<std::uint64_t>(lower_bits[y]) << (8 * y + 32);
  }
  return set;
}

// The pixels of a block that are outside an edge which leaves out some and not others. The sign of
// its value is that of value / 256, rounded down, and a and b are multiples of 256: no value / 256
// is then farther from 0 than 14 (|a| + |b|) / 256.
std::uint64_t outside(const EdgeFunction& edge, int x0, int y0) {
  std::uint64_t set = 0;
  if (std::abs(edge.a) + std::abs(edge.b) >= std::int64_t{1} << 35) {
    for (int bit = 0; bit < 64; ++bit) {
      if (!edge.inside(x0 + bit % 8, y0 + bit / 8)) set |= std::uint64_t{1} << bit;
    }
    return set;
  }
  const auto value = static_cast<std::int32_t>(edge.at(x0, y0) >> 8);
  const auto a = static_cast<std::int32_t>(edge.a / 256);
  const auto b = static_cast<std::int32_t>(edge.b / 256);
  return outside_rows(value, a, b);
}

}  // namespace

std::uint64_t covered(const SetupPolygon& polygon, const BlockPart& part) {
  const PixelBox& bounds = polygon.bounds;
  const int x0 = std::max(part.x0, bounds.x0);
  const int x1 = std::min(part.x1, bounds.x1);
  const int y0 = std::max(part.y0, bounds.y0);
  const int y1 = std::min(part.y1, bounds.y1);
  if (x0 >= x1 || y0 >= y1) return 0;
  constexpr std::uint64_t kFirstColumn = 0x0101010101010101;
  const std::uint64_t row = ((std::uint64_t{1} << (x1 - x0)) - 1) << (x0 % 8);
  const std::uint64_t rows = ~std::uint64_t{0} >> (8 * (8 - (y1 - y0))) << (8 * (y0 % 8));
  std::uint64_t set = row * kFirstColumn & rows;
  for (const EdgeFunction& edge : polygon.edges) {
    if (edge.misses(x0, y0, x1, y1)) return 0;
    // All inside, if the corner that is the least inside is.
    if (edge.inside(edge.a >= 0 ? x0 : x1 - 1, edge.b >= 0 ? y0 : y1 - 1)) continue;
    set &= ~outside(edge, 8 * part.bx(), 8 * part.by());
    if (set == 0) return 0;
  }
  return set;
}

TileSpan touched(const SetupPolygon& polygon, const PixelBox& row, int tile) {
  const PixelBox& bounds = polygon.bounds;
  if (row.y0 >= bounds.y1 || row.y1 <= bounds.y0 || row.x1 <= bounds.x0) return {};
  TileSpan span{bounds.x0 / tile, (bounds.x1 + tile - 1) / tile};
  for (const EdgeFunction& edge : polygon.edges) {
    // An edge is the most inside at a tile's right or left end: it leaves out the first tiles, or
    // the last.
    const std::int64_t rest = edge.b * (edge.b >= 0 ? row.y1 - 1 : row.y0) + edge.c;
    const auto misses = [&](int x) { return edge.a * x + rest < 0; };
    if (edge.a >= 0) {
      while (!span.empty() && misses(std::min((span.first + 1) * tile, row.x1) - 1)) ++span.first;
    } else {
      while (!span.empty() && misses((span.end - 1) * tile)) --span.end;
    }
  }
  return span;
}

}  // namespace wedgesim::model::units
