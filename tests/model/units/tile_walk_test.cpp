// Does the walk take its cycles for each tile that it steps over?
#include "model/units/tile_walk.h"

#include "tests/model/units/pipeline.h"

namespace wedgesim::model::units::test {
namespace {

struct TileWalkTest : BothTimings {};

// 3 cycles a tile. The first wedge comes in 1: a step to its first tile (4), four to its second
// (16), two behind it (22). The second wedge touches no tile: 23. The third has one: 26. What goes
// in a cycle is there in the next.
TEST_P(TileWalkTest, EveryTouchedTileTakesItsCycles) {
  const ScopedSimulation simulation;
  Pipeline pipeline;
  const TileWalk unit("tile_walk", GetParam(), {3, {}}, pipeline.in, pipeline.out);
  PrimitiveWork* const first = wedge_work(0, {walked_tile(5, {}), walked_tile(9, {})});
  first->tiles[1].steps = 4;
  first->steps_after = 2;
  pipeline.run(unit,
               {{Token::Kind::work, 0, first},
                {Token::Kind::work, 0, wedge_work(1, {})},
                {Token::Kind::work, 0, wedge_work(2, {walked_tile(2, {})})}},
               3);
  EXPECT_EQ(pipeline.popped, (std::vector<Cycle>{5, 17, 27}));
  EXPECT_EQ(pipeline.items[1].tile, 1U);
  EXPECT_EQ(pipeline.items[1].work().tile, 9U);
  EXPECT_EQ(pipeline.items[2].wedge(), 2);
  EXPECT_EQ(statistic(unit, "tiles"), 8U);
  EXPECT_EQ(unit.time().busy(), 21U + 1 + 3 + 1);  // the end takes one
}

WEDGESIM_BOTH_TIMINGS(TileWalkTest);

}  // namespace
}  // namespace wedgesim::model::units::test
