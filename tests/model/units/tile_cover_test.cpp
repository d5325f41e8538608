// Are a polygon's pixels in a block, and the tiles that its edges let pass, those that one finds by
// asking each edge at each pixel, and at each tile's corner?
#include "model/units/tile_cover.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

namespace wedgesim::model::units {
namespace {

constexpr int kWidth = 45;  // no multiple of a tile
constexpr int kHeight = 27;
constexpr std::uint32_t kSeed = 11;

// A triangle with corners up to `reach` pixels from the frame's middle.
SetupPolygon random_polygon(std::mt19937& random, int reach) {
  std::uniform_int_distribution<std::int64_t> offset(-256 * std::int64_t{reach},
                                                     256 * std::int64_t{reach});
  std::int64_t x[3];
  std::int64_t y[3];
  for (int i = 0; i < 3; ++i) {
    x[i] = 128 * kWidth + offset(random);
    y[i] = 128 * kHeight + offset(random);
  }
  if ((x[1] - x[0]) * (y[2] - y[0]) < (x[2] - x[0]) * (y[1] - y[0])) {
    std::swap(x[1], x[2]);
    std::swap(y[1], y[2]);
  }
  SetupPolygon polygon;
  for (int i = 0; i < 3; ++i) {
    const int k = (i + 1) % 3;
    polygon.edges.push_back(datapath::EdgeFunction::between(x[i], y[i], x[k], y[k]));
  }
  const auto pixel = [](std::int64_t coordinate, int limit) {
    return static_cast<int>(std::clamp<std::int64_t>((coordinate + 127) >> 8, 0, limit));
  };
  polygon.bounds = {pixel(*std::min_element(x, x + 3), kWidth),
                    pixel(*std::min_element(y, y + 3), kHeight),
                    pixel(*std::max_element(x, x + 3) + 1, kWidth),
                    pixel(*std::max_element(y, y + 3) + 1, kHeight)};
  return polygon;
}

bool contains(const SetupPolygon& polygon, int x, int y) {
  const PixelBox& bounds = polygon.bounds;
  return x >= bounds.x0 && x < bounds.x1 && y >= bounds.y0 && y < bounds.y1 &&
         std::all_of(polygon.edges.begin(), polygon.edges.end(),
                     [&](const auto& edge) { return edge.inside(x, y); });
}

bool touches(const SetupPolygon& polygon, const PixelBox& tile) {
  const PixelBox& bounds = polygon.bounds;
  return tile.x0 < bounds.x1 && tile.x1 > bounds.x0 && tile.y0 < bounds.y1 && tile.y1 > bounds.y0 &&
         std::none_of(polygon.edges.begin(), polygon.edges.end(), [&](const auto& edge) {
           return edge.misses(tile.x0, tile.y0, tile.x1, tile.y1);
         });
}

// Reaches from slivers to triangles whose edges need 64 bits.
constexpr int kReaches[] = {1, 8, 40, 1000, 1 << 19};

TEST(TileCover, CoversWhatEveryEdgeHoldsInside) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int i = 0; i < 2000; ++i) {
    const SetupPolygon polygon = random_polygon(random, kReaches[i % 5]);
    for (int y0 = 0; y0 < kHeight; y0 += 4) {
      for (int x0 = 0; x0 < kWidth; x0 += 4) {
        const int size = (x0 + y0) % 8 == 0 ? 8 : 4;
        const BlockPart part{x0, y0, std::min({x0 + size, (x0 / 8 + 1) * 8, kWidth}),
                             std::min({y0 + size, (y0 / 8 + 1) * 8, kHeight})};
        std::uint64_t expected = 0;
        for (int y = part.y0; y < part.y1; ++y) {
          for (int x = part.x0; x < part.x1; ++x) {
            if (contains(polygon, x, y)) expected |= std::uint64_t{1} << bit_of(x, y);
          }
        }
        ASSERT_EQ(covered(polygon, part), expected) << "polygon " << i << " at " << x0 << " " << y0;
      }
    }
  }
}

TEST(TileCover, TouchesTilesThatNoEdgeLeavesOutAlone) {
  SCOPED_TRACE(testing::Message() << "seed " << kSeed);
  std::mt19937 random(kSeed);
  for (int i = 0; i < 5000; ++i) {
    const SetupPolygon polygon = random_polygon(random, kReaches[i % 5]);
    const int tile = 2 << (i / 5 % 5);
    for (int ty = 0; ty * tile < kHeight; ++ty) {
      const int y1 = std::min((ty + 1) * tile, kHeight);
      const TileSpan span = touched(polygon, {0, ty * tile, kWidth, y1}, tile);
      for (int tx = 0; tx * tile < kWidth; ++tx) {
        const PixelBox box{tx * tile, ty * tile, std::min((tx + 1) * tile, kWidth), y1};
        ASSERT_EQ(span.holds(tx), touches(polygon, box))
            << "polygon " << i << ", tile edge " << tile << ", at " << tx << " " << ty;
      }
    }
  }
}

}  // namespace
}  // namespace wedgesim::model::units
