#include "model/datapath/edge_function.h"

#include <gtest/gtest.h>

#include <array>
#include <iostream>
#include <random>

#include "model/count/raster.h"

namespace wedgesim::model::datapath {
namespace {

// Against spans found by division, on triangles small enough for ties to be common.
TEST(EdgeFunction, CoversWhatTheCountersSpansCover) {
  const unsigned seed = 17;
  std::cout << "seed " << seed << '\n';
  std::mt19937 random(seed);
  const auto coordinate = [&] { return 128 * static_cast<std::int64_t>(random() % 24); };
  std::size_t covered = 0;
  for (int i = 0; i < 5000; ++i) {
    std::array<Snapped, 3> v;
    for (Snapped& p : v) p = {coordinate(), coordinate()};
    const Outline outline(v);
    if (outline.empty()) continue;
    if (outline.eye_facing()) std::swap(v[1], v[2]);  // clockwise
    std::array<EdgeFunction, 3> edges;
    for (std::size_t k = 0; k < 3; ++k) {
      const Snapped& p = v[k];
      const Snapped& q = v[(k + 1) % 3];
      edges[k] = EdgeFunction::between(p.x, p.y, q.x, q.y);
    }
    for (int y = 0; y < 12; ++y) {
      for (int x = 0; x < 12; ++x) {
        const bool inside = edges[0].inside(x, y) && edges[1].inside(x, y) && edges[2].inside(x, y);
        ASSERT_EQ(inside, outline.covers(x, y)) << x << ',' << y << " triangle " << i;
        covered += inside ? 1 : 0;
      }
    }
  }
  EXPECT_GT(covered, 50000U);
}

TEST(EdgeFunction, MissesABoxIffItMissesAllOfItsPixels) {
  std::mt19937 random(18);
  const auto coordinate = [&] { return static_cast<std::int64_t>(random() % 4096); };
  int missed = 0;
  for (int i = 0; i < 5000; ++i) {
    const EdgeFunction edge =
        EdgeFunction::between(coordinate(), coordinate(), coordinate(), coordinate());
    bool any = false;
    for (int y = 4; y < 8; ++y) {
      for (int x = 4; x < 8; ++x) any = any || edge.inside(x, y);
    }
    ASSERT_EQ(edge.misses(4, 4, 8, 8), !any);
    missed += any ? 0 : 1;
  }
  EXPECT_GT(missed, 500);
}

}  // namespace
}  // namespace wedgesim::model::datapath
