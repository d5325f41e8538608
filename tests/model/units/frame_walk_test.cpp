// In which order do primitives and passes come, and what is a unit told of each?
#include "model/units/frame_walk.h"

#include <gtest/gtest.h>

#include "tests/model/count/synthetic.h"

namespace wedgesim::model::units {
namespace {

using test::Facing;
using test::Point;

/// A wedge over all four tiles of 16x16 pixels, its umbra polygon over one, and a lone polygon that
/// faces away.
struct FrameWalkTest : testing::Test {
  FrameWalkTest() {
    const std::uint32_t plane = source.add_plane(0.0, 0.0, 1.0, -0.1);
    source.add_face(square(2.0, 14.0), Facing::eye, plane);
    const std::uint32_t wedge = source.add_wedge(traces::fb::WedgeKind_coverage, {plane}, 0.1, 0.9);
    source.add_umbra(square(1.0, 7.0), Facing::eye, plane, wedge);
    source.add_umbra(square(9.0, 15.0), Facing::away, plane, traces::kNone);
    view = source.trace.view();
  }
  static std::vector<Point> square(double low, double high) {
    return {{low, low, 0.2}, {high, low, 0.2}, {high, high, 0.2}, {low, high, 0.2}};
  }
  std::vector<std::shared_ptr<const PrimitiveWork>> works(Mode mode) {
    CountConfig config;
    config.mode = mode;
    config.tile = 8;
    config.cull = Cull::none;
    config.umbra_cull = UmbraCull::none;
    FrameWalk walk(view, config, false, {});
    std::vector<std::shared_ptr<const PrimitiveWork>> all;
    while (auto work = walk.next()) all.push_back(std::move(work));
    return all;
  }
  test::SyntheticTrace source{16, 16, 0.5};
  traces::TraceView view;
};

TEST_F(FrameWalkTest, SinglePassTakesWedgesThenLonePolygons) {
  const auto all = works(Mode::single_pass);
  ASSERT_EQ(all.size(), 2U);
  const PrimitiveWork& wedge = *all[0];
  EXPECT_EQ(wedge.wedge, 0U);
  EXPECT_GT(wedge.record_bytes, 0U);
  EXPECT_EQ(wedge.planes, 2U);  // its own and the umbra polygon's
  EXPECT_EQ(wedge.edges, 8U);
  ASSERT_EQ(wedge.tiles.size(), 4U);
  for (std::uint32_t i = 0; i < 4; ++i) {
    EXPECT_EQ(wedge.tiles[i].tile, i);
    EXPECT_EQ(wedge.tiles[i].steps, 1U);
  }
  EXPECT_EQ(wedge.steps_after, 0U);
  const PrimitiveWork& lone = *all[1];
  EXPECT_FALSE(lone.wedge.has_value());
  EXPECT_EQ(lone.record_bytes, 0U);
  ASSERT_EQ(lone.tiles.size(), 1U);
  EXPECT_EQ(lone.tiles[0].tile, 3U);
  EXPECT_FALSE(wedge.barrier || lone.barrier);
}

// Umbra that faces as the faces do, umbra that does not, the merge, penumbra; a barrier before each
// but the first.
TEST_F(FrameWalkTest, ThreePassHasBarriersAndAMerge) {
  const auto all = works(Mode::three_pass);
  ASSERT_EQ(all.size(), 4U);
  EXPECT_EQ(all[0]->wedge, 0U);
  EXPECT_EQ(all[0]->edges, 4U);
  ASSERT_EQ(all[0]->tiles.size(), 1U);
  EXPECT_FALSE(all[0]->barrier);
  EXPECT_FALSE(all[1]->wedge.has_value());
  EXPECT_TRUE(all[1]->barrier);
  EXPECT_TRUE(all[2]->barrier);
  ASSERT_EQ(all[2]->merged.size(), 4U);
  EXPECT_TRUE(all[2]->merged[0].any);
  EXPECT_FALSE(all[2]->merged[1].any);
  EXPECT_EQ(all[3]->wedge, 0U);
  EXPECT_TRUE(all[3]->barrier);
  EXPECT_EQ(all[3]->planes, 1U);
  EXPECT_EQ(all[3]->tiles.size(), 4U);
}

}  // namespace
}  // namespace wedgesim::model::units
