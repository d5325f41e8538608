// What a triangle covers of a band's rows, all rows at once, against the rows of spans.h.
#include <gtest/gtest.h>

#include <array>
#include <numeric>
#include <vector>

#include "functional/raster/map_blocks_simd.h"
#include "functional/raster/spans.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 37;  // neither of bands nor of blocks
constexpr int kPadded = 48;

// Often on the line of a row's centres, often far outside.
std::int32_t random_coordinate(Random& random) {
  if (random.chance(0.3)) return 256 * random.whole(-3, kSize + 3) + 128;
  if (random.chance(0.2)) return random.whole(-2000000, 2000000);
  return random.whole(-3 * 256, (kSize + 3) * 256);
}

struct Ends {
  int begin, end;
};

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
      std::array<Ends, MapTriangles::kBandRows> expected;
      expected.fill({kSize, 0});
      for_each_span(outline, kSize, y, std::min(kSize, y + MapTriangles::kBandRows),
                    [&](int row, int x_begin, int x_end) {
                      expected[static_cast<std::size_t>(row - y)] = {x_begin, x_end};
                    });
      HWY_NAMESPACE::TriangleRows rows;
      rows.cover(triangle, kSize, y);
      for (std::size_t row = 0; row < expected.size(); ++row) {
        ASSERT_EQ(rows.begin[row], static_cast<float>(expected[row].begin)) << i << ' ' << y;
        ASSERT_EQ(rows.end[row], static_cast<float>(expected[row].end)) << i << ' ' << y;
        covered += expected[row].end > 0 ? 1 : 0;
      }
    }
  }
  EXPECT_GT(covered, 20000) << "seed 64";
}

// Both ways to find what is covered: of small triangles and of others.
TEST(MapBlocks, VisitEveryTexelOnce) {
  namespace kernels = HWY_NAMESPACE;
  Random random(65);
  std::size_t small = 0;
  for (int i = 0; i < 20000; ++i) {
    MapTriangle triangle;
    std::array<SnappedPoint, 3> outline;
    const bool near = random.chance(0.7);
    for (std::size_t k = 0; k < 3; ++k) {
      const auto coordinate = [&](int first) {
        if (!near || k == 0) return random_coordinate(random);
        return first + (random.chance(0.3) ? 256 * random.whole(-8, 8) : random.whole(-2048, 2048));
      };
      outline[k] = {coordinate(outline[0].x), coordinate(outline[0].y), 0.0};
      triangle.corners[k] = {outline[k].x, outline[k].y};
    }
    const std::int64_t area = doubled_area(outline);
    if (area == 0) continue;
    triangle.faces_light = area < 0;
    std::vector<int> expected(kPadded * kPadded, 0);
    for_each_span(outline, kSize, 0, kSize, [&](int y, int x_begin, int x_end) {
      for (int x = x_begin; x < x_end; ++x) ++expected[static_cast<std::size_t>(y * kPadded + x)];
    });
    std::vector<int> drawn(kPadded * kPadded, 0);
    std::uint64_t texels = 0;
    for (int y = 0; y < kSize; y += MapTriangles::kBandRows) {
      texels += kernels::for_each_block(
          triangle, kSize, y, [&](int column, int row, const auto& covered) {
            small += sizeof(covered) == sizeof(kernels::BlockSides) ? 1 : 0;
            const int x = column * kBlockEdge;
            for (int lane = 0; lane < kBlock; lane += kernels::kLanes) {
              HWY_ALIGN float on[kBlock];
              kernels::store(
                  hwy::HWY_NAMESPACE::IfThenElseZero(covered.covered(x, lane), kernels::set(1.0F)),
                  on);
              for (int k = 0; k < kernels::kLanes; ++k) {
                const int at_x = x + (lane + k) % kBlockEdge;
                const int at_y = y + row * kBlockEdge + (lane + k) / kBlockEdge;
                drawn[static_cast<std::size_t>(at_y * kPadded + at_x)] += on[k] > 0.0F ? 1 : 0;
              }
            }
          });
    }
    ASSERT_EQ(drawn, expected) << "triangle " << i << " of seed 65";
    ASSERT_EQ(texels, static_cast<std::uint64_t>(std::accumulate(drawn.begin(), drawn.end(), 0)));
  }
  EXPECT_GT(small, 5000U) << "seed 65";
}

}  // namespace
}  // namespace wedgesim::functional
