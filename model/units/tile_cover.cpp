#include "model/units/tile_cover.h"

#include <algorithm>

namespace wedgesim::model::units {

namespace {

// Of eight values first, first + step, ... that grow, how many are negative: by halves.
int negatives(std::int64_t first, std::int64_t step) {
  int count = first + 3 * step < 0 ? 4 : 0;
  if (first + (count + 1) * step < 0) count += 2;
  if (first + count * step < 0) count += 1;
  return count == 7 && first + 7 * step < 0 ? 8 : count;
}

// The pixels of a block's row that are inside an edge, bit x; \p value is that of x = 0.
std::uint64_t row_inside(std::int64_t value, std::int64_t a) {
  if (a >= 0) return 0xffU & (0xffU << negatives(value, a));
  return 0xffU >> negatives(value + 7 * a, -a);
}

}  // namespace

std::uint64_t covered(const SetupPolygon& polygon, const BlockPart& part) {
  const PixelBox& bounds = polygon.bounds;
  const int x0 = std::max(part.x0, bounds.x0);
  const int x1 = std::min(part.x1, bounds.x1);
  const int y0 = std::max(part.y0, bounds.y0);
  const int y1 = std::min(part.y1, bounds.y1);
  if (x0 >= x1 || y0 >= y1) return 0;
  const std::uint64_t row = ((std::uint64_t{1} << (x1 - x0)) - 1) << (x0 % 8);
  std::uint64_t set = 0;
  for (int y = y0; y < y1; ++y) set |= row << (8 * (y % 8));
  for (const datapath::EdgeFunction& edge : polygon.edges) {
    if (edge.misses(x0, y0, x1, y1)) return 0;
    // All inside, if the corner that is the least inside is.
    if (edge.inside(edge.a >= 0 ? x0 : x1 - 1, edge.b >= 0 ? y0 : y1 - 1)) continue;
    std::int64_t value = edge.at(x0 / 8 * 8, y0);
    std::uint64_t inside = 0;
    for (int y = y0; y < y1; ++y, value += edge.b) {
      inside |= row_inside(value, edge.a) << (8 * (y % 8));
    }
    set &= inside;
    if (set == 0) return 0;
  }
  return set;
}

bool touches(const SetupPolygon& polygon, const PixelBox& tile) {
  const PixelBox& bounds = polygon.bounds;
  if (tile.x0 >= bounds.x1 || tile.x1 <= bounds.x0 || tile.y0 >= bounds.y1 ||
      tile.y1 <= bounds.y0) {
    return false;
  }
  return std::none_of(polygon.edges.begin(), polygon.edges.end(), [&](const auto& edge) {
    return edge.misses(tile.x0, tile.y0, tile.x1, tile.y1);
  });
}

}  // namespace wedgesim::model::units
