// Which lines of depth are read when, and when does a tile go on? A memory of 10 cycles.
#include "model/units/z_read.h"

#include "tests/model/units/pipeline.h"

namespace wedgesim::model::units::test {
namespace {

using Accesses = std::vector<FakeMemory::Access>;

struct ZReadTest : BothTimings {
  Surroundings around;
  Pipeline pipeline;

  void run(const ZReadConfig& config, const std::vector<Token>& tokens) {
    const ZRead unit("z_read", GetParam(), config, around.port, around.layout, pipeline.in,
                     pipeline.out);
    pipeline.run(unit, tokens, tokens.size());
    memory_cycles = unit.time().memory();
    busy = unit.time().busy() - 1;  // without the end's
    hits = unit.cache().hits();
  }
  Cycle memory_cycles = 0, busy = 0;
  std::uint64_t hits = 0;
};

// A whole block of words of 4 bytes is 4 lines; the second block begins at 4096 + 256. In 1, a line
// a cycle, the last in 5, back in 15.
TEST_P(ZReadTest, ALineACycle) {
  run({}, {tile_token(0, 1, {block_work(1, 0, first_pixels(64))})});
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{2, 4352, false}, {3, 4416, false}, {4, 4480, false}, {5, 4544, false}}));
  EXPECT_EQ(pipeline.popped, std::vector<Cycle>{15});
  EXPECT_EQ(busy, 4U);
}

// 16 pixels are a line; another wedge finds it, a cycle later, still on its way.
TEST_P(ZReadTest, OnlyLinesWithPixelsThatAreRead) {
  run({}, {tile_token(0, 0, {block_work(0, 0, 1)}), tile_token(1, 0, {block_work(0, 0, 2)})});
  EXPECT_EQ(around.memory.accesses, (Accesses{{2, 4096, false}}));
  EXPECT_EQ(pipeline.popped, (std::vector<Cycle>{12, 12}));
  EXPECT_EQ(hits, 1U);
}

// Two under way: the third line leaves when the first is back, in 12; the fourth in 13, back in 23.
TEST_P(ZReadTest, NoMoreLinesThanAllowedAreUnderWay) {
  ZReadConfig config;
  config.outstanding = 2;
  run(config, {tile_token(0, 0, {block_work(0, 0, first_pixels(64))})});
  EXPECT_EQ(around.memory.accesses.back(), (FakeMemory::Access{13, 4096 + 192, false}));
  EXPECT_EQ(pipeline.popped, std::vector<Cycle>{23});
  EXPECT_EQ(memory_cycles, 8U);
}

// Accepted without a look at z: umbra writes alone.
TEST_P(ZReadTest, ATileThatReadsNothingTakesACycle) {
  run({}, {tile_token(0, 0, {{0, 0, 0, 0, 0, first_pixels(64)}})});
  EXPECT_TRUE(around.memory.accesses.empty());
  EXPECT_EQ(pipeline.popped, std::vector<Cycle>{3});
  EXPECT_EQ(busy, 1U);
}

WEDGESIM_BOTH_TIMINGS(ZReadTest);

}  // namespace
}  // namespace wedgesim::model::units::test
