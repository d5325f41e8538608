#include "model/units/tile_cover.h"

#include <algorithm>

namespace wedgesim::model::units {

std::uint64_t covered(const SetupPolygon& polygon, const BlockPart& part) {
  const PixelBox& bounds = polygon.bounds;
  const int x0 = std::max(part.x0, bounds.x0);
  const int x1 = std::min(part.x1, bounds.x1);
  const int y0 = std::max(part.y0, bounds.y0);
  const int y1 = std::min(part.y1, bounds.y1);
  if (x0 >= x1 || y0 >= y1) return 0;
  std::uint64_t set = 0;
  for (int y = y0; y < y1; ++y) set |= ((std::uint64_t{1} << (x1 - x0)) - 1) << bit_of(x0, y);
  for (const datapath::EdgeFunction& edge : polygon.edges) {
    if (edge.misses(x0, y0, x1, y1)) return 0;
    // All inside, if the corner that is the least inside is.
    if (edge.inside(edge.a >= 0 ? x0 : x1 - 1, edge.b >= 0 ? y0 : y1 - 1)) continue;
    for (int y = y0; y < y1; ++y) {
      std::int64_t value = edge.at(x0, y);
      for (int x = x0; x < x1; ++x, value += edge.a) {
        set &= ~(static_cast<std::uint64_t>(value < 0) << bit_of(x, y));
      }
    }
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
