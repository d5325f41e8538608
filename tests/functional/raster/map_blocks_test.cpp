// What a triangle covers of a band's rows, all rows at once, against the rows of spans.h.
#include <gtest/gtest.h>

#include <array>
#include <iostream>

#include "functional/raster/map_blocks_simd.h"
#include "functional/raster/spans.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 37;  // neither of bands nor of blocks

// Often on the line of a row's centres, often far outside.
std::int32_t random_coordinate(Random& random) {
  if (random.chance(0.3)) return 256 * random.whole(-3, kSize + 3) + 128;
  if (random.chance(0.2)) return random.whole(-2000000, 2000000);
  return random.whole(-3 * 256, (kSize + 3) * 256);
}

TEST(MapBlocks, CoverTheRowsOfSpans) {
  Random random(64);
  int covered = 0;
  for (int i = 0; i < 20000; ++i) {
    MapTriangle triangle;
    std::array<SnappedPoint, 3> outline;
    for (std::size_t k = 0; k < 3; ++k) {
      outline[k] = {random_coordinate(random), random_coordinate(random), 0.0};
      triangle.corners[k] = {outline[k].x, outline[k].y};
    }
    const std::int64_t area = doubled_area(outline);
    if (area == 0) continue;
    triangle.faces_light = area < 0;
    for (int y = 0; y < kSize; y += MapTriangles::kBandRows) {
      std::array<PixelSpan, MapTriangles::kBandRows> expected;
      expected.fill({0, kSize, 0});
      for_each_span(outline, kSize, y, std::min(kSize, y + MapTriangles::kBandRows),
                    [&](int row, int x_begin, int x_end) {
                      expected[static_cast<std::size_t>(row - y)] = {row, x_begin, x_end};
                    });
      HWY_NAMESPACE::TriangleRows rows;
      rows.cover(triangle, kSize, y);
      for (std::size_t row = 0; row < expected.size(); ++row) {
        ASSERT_EQ(rows.begin[row], static_cast<float>(expected[row].x_begin)) << i << ' ' << y;
        ASSERT_EQ(rows.end[row], static_cast<float>(expected[row].x_end)) << i << ' ' << y;
        covered += expected[row].x_end > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(covered, 20000) << "seed 64";
}

}  // namespace
}  // namespace wedgesim::functional
