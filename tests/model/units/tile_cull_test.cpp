// When are a tile's depths looked up, and what goes on? A memory of 10 cycles; 2x2 tiles.
#include "model/units/tile_cull.h"

#include "tests/model/units/pipeline.h"

namespace wedgesim::model::units::test {
namespace {

struct TileCullTest : BothTimings {
  Surroundings around;
  Pipeline pipeline;
  TileCullConfig config;
  TileCull unit{"tile_cull",   GetParam(), config,      around.port,
                around.layout, 2,          pipeline.in, pipeline.out};
};

// Tile 3 is (1, 1): word 9 of the surface at 16384, in its second line. Looked up in 1, back in 11;
// the tests take until 4. The second wedge's word comes with it. The third tests name no depth.
TEST_P(TileCullTest, AVisitACycleAndAReadThatOverlaps) {
  Token first = tile_token(0, 3, {block_work(1, 1, 1)});
  Token second = tile_token(1, 3, {block_work(1, 1, 1)});
  Token third = tile_token(2, 0, {block_work(0, 0, 1)});
  const auto tile = [](Token& token) -> TileWork& {
    return const_cast<PrimitiveWork&>(*token.primitive).tiles[0];
  };
  tile(first).visits = 3;
  tile(second).visits = 16;
  tile(third).words = 0;
  pipeline.run(unit, {first, second, third}, 3);
  EXPECT_EQ(around.memory.accesses, (std::vector<FakeMemory::Access>{{1, 16384 + 64, false}}));
  EXPECT_EQ(pipeline.popped, (std::vector<Cycle>{11, 21, 22}));
  EXPECT_EQ(unit.cache().hits(), 1U);
  EXPECT_EQ(statistic(unit, "visits"), 20U);
}

TEST_P(TileCullTest, WhatIsCulledDoesNotGoOn) {
  pipeline.run(
      unit, {tile_token(0, 0, {}), tile_token(1, 0, {}), tile_token(2, 0, {block_work(0, 0, 1)})},
      1);
  EXPECT_EQ(pipeline.items[0].wedge(), 2);
  EXPECT_EQ(pipeline.popped, (std::vector<Cycle>{11}));
  EXPECT_EQ(statistic(unit, "tiles_culled"), 2U);
  EXPECT_EQ(unit.time().busy(), 4U);
}

WEDGESIM_BOTH_TIMINGS(TileCullTest);

}  // namespace
}  // namespace wedgesim::model::units::test
