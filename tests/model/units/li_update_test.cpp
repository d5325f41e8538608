// When are words of LI and stencil read and written, and is a word in change waited for? A memory
// of 10 cycles, 3 cycles from a word's read to its write.
#include "model/units/li_update.h"

#include "tests/model/units/bench.h"
#include "tests/model/units/work.h"

namespace wedgesim::model::units::test {
namespace {

using Accesses = std::vector<FakeMemory::Access>;
using Offers = std::vector<std::pair<Cycle, Token>>;

Token pixels(std::uint64_t set, int bx = 0) {
  return tile_token(0, static_cast<std::uint32_t>(bx), {block_work(bx, 0, set)});
}

struct LiUpdateTest : BothTimings {
  LiUpdateTest() { config.clear = Clear::none; }

  // Tokens are there a cycle after they are offered.
  void run(Offers offers) {
    offers.emplace_back(0, mark(Token::Kind::end));
    Link<Token> in("source to li_update", {64, 1});
    Source<Token> source("source", GetParam(), in, std::move(offers));
    LiUpdate unit("li_update", GetParam(), config, three_pass, around.port, around.layout, in);
    unit.on_drained([this](Cycle cycle, const CriticalPath&) { drained = cycle; });
    sc_core::sc_start();
    ASSERT_TRUE(unit.finished());
    const UnitTime& time = unit.time();
    EXPECT_EQ(time.busy() + time.starved() + time.stalled(), time.now());
    hazards = statistic(unit, "hazard_cycles");
    end = time.now();
    memory_cycles = time.memory();
    write_backs = unit.li_cache().write_backs();
  }

  Surroundings around;
  LiUpdateConfig config;
  bool three_pass = false;
  std::uint64_t hazards = 0, write_backs = 0;
  Cycle end = 0, memory_cycles = 0, drained = 0;
};

// Read in 2, back in 12; the end comes at once: its words are written in 15, and the line leaves a
// cycle later.
TEST_P(LiUpdateTest, ALineIsReadThenFlushed) {
  run({{0, pixels(1)}});
  EXPECT_EQ(around.memory.accesses, (Accesses{{2, 8192, false}, {16, 8192, true}}));
  EXPECT_EQ(write_backs, 1U);
}

// A block of LI is two lines, in cycles 2 and 3.
TEST_P(LiUpdateTest, ALineACycle) {
  run({{0, pixels(first_pixels(64))}});
  EXPECT_EQ(around.memory.accesses.size(), 4U);
  EXPECT_EQ(around.memory.accesses[1], (FakeMemory::Access{3, 8256, false}));
}

// The second comes in 2, but the word is back in 12 and written in 15: 13 cycles too early.
TEST_P(LiUpdateTest, AWordThatIsOnItsWayIsNotReadTwice) {
  run({{0, pixels(1)}, {0, pixels(1)}});
  EXPECT_EQ(hazards, 13U);
  EXPECT_EQ(end, 16U + 3 + 1);
}

// The line is there since 12. Updates of pixel 0 come in 31 (read in 32, written in 35), at once
// again, and exactly when that one is written.
TEST_P(LiUpdateTest, TheSamePixelWaitsExactlyUntilItIsWritten) {
  const auto again = [this](Cycle cycle) {
    run({{0, pixels(1)}, {30, pixels(1)}, {cycle, pixels(1)}});
    return hazards;
  };
  EXPECT_EQ(again(30), 3U);
}
TEST_P(LiUpdateTest, ACycleBeforeItIsWrittenItWaitsACycle) {
  run({{0, pixels(1)}, {30, pixels(1)}, {33, pixels(1)}});
  EXPECT_EQ(hazards, 1U);
}
TEST_P(LiUpdateTest, WhenItIsWrittenItDoesNotWait) {
  run({{0, pixels(1)}, {30, pixels(1)}, {34, pixels(1)}});
  EXPECT_EQ(hazards, 0U);
}

TEST_P(LiUpdateTest, AnotherPixelOfTheBlockDoesNotWait) {
  run({{0, pixels(3)}, {30, pixels(1)}, {30, pixels(2)}});
  EXPECT_EQ(hazards, 0U);
  EXPECT_EQ(end, 33U + 3 + 1);
}

// Unshared, the pixel of face and umbra polygon is changed twice: 12 + 3 - 2 cycles between.
TEST_P(LiUpdateTest, APixelOfBothPolygonsIsChangedTwiceUnlessShared) {
  run({{0, tile_token(0, 0, {{0, 0, 3, 3, 3, 1}})}});
  EXPECT_EQ(hazards, 13U);
}

// One line of cache. The second line's read has to wait until the first is in (12), its word
// written (15), and out again.
TEST_P(LiUpdateTest, ALineIsNotPutOutBeforeItIsIn) {
  config.cache = {64, 64, 1};
  run({{0, pixels(1)}, {0, pixels(1, 1)}});
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{2, 8192, false}, {15, 8192, true}, {15, 8320, false}, {29, 8320, true}}));
  EXPECT_EQ(write_backs, 2U);
  EXPECT_EQ(memory_cycles, 9U + 10);  // from 3 to 12; from 15 to 25, at the end
}

// The word comes in 31, is read in 32 and written in 35; the other line is asked for in 33.
TEST_P(LiUpdateTest, AWordInChangeIsWrittenBeforeItsLineIsPutOut) {
  config.cache = {64, 64, 1};
  run({{0, pixels(1)}, {30, pixels(1)}, {30, pixels(1, 1)}});
  EXPECT_EQ(around.memory.accesses[1], (FakeMemory::Access{35, 8192, true}));
}

// Who wrote a line last pays for writing it back, not who puts it out, nor nobody at the end.
TEST_P(LiUpdateTest, AWrittenBackLineBearsItsLastWriter) {
  config.cache = {64, 64, 1};
  std::vector<memory::MemoryRecord> writes;
  around.port.listen([&](const memory::MemoryRecord& record) {
    if (record.write) writes.push_back(record);
  });
  run({{0, tile_token(4, 0, {block_work(0, 0, 1)})},
       {30, tile_token(5, 0, {block_work(0, 0, 2)})},
       {60, tile_token(6, 1, {block_work(1, 0, 1)})}});
  ASSERT_EQ(writes.size(), 2U);
  EXPECT_EQ(writes[0].cause, memory::Cause::write_back);
  EXPECT_EQ(writes[0].wedge, 5);
  EXPECT_EQ(writes[0].tile, 0);
  EXPECT_EQ(writes[1].cause, memory::Cause::flush);
  EXPECT_EQ(writes[1].wedge, 6);
  EXPECT_EQ(writes[1].tile, 1);
}

// A memory of 10 cycles and two writes under way: two lines every 10 cycles, from 1 and 2 on.
TEST_P(LiUpdateTest, NoMoreWritesThanAllowedAreUnderWay) {
  config.clear = Clear::write;
  config.outstanding_writes = 2;
  run({});
  ASSERT_EQ(around.memory.accesses.size(), 8U);
  for (std::size_t i = 0; i < 8; ++i) {
    EXPECT_EQ(around.memory.accesses[i].cycle, 1 + i % 2 + i / 2 * 10) << i;
  }
  EXPECT_EQ(memory_cycles, 3U * 8);
}

// Read in 2, there in 12, written in 15; then the next.
TEST_P(LiUpdateTest, WithoutACacheLinesAreWrittenOneByOne) {
  config.cache = {0, 64, 1};
  run({{0, pixels(1)}, {0, pixels(1)}});
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{2, 8192, false}, {15, 8192, true}, {16, 8192, false}, {29, 8192, true}}));
  EXPECT_EQ(hazards, 0U);
}

// Two fills under way: the third, in 4, leaves when the first is back, in 12.
TEST_P(LiUpdateTest, NoMoreFillsThanAllowedAreUnderWay) {
  config.outstanding = 2;
  run({{0, pixels(first_pixels(64))}, {0, pixels(1, 1)}});
  EXPECT_EQ(around.memory.accesses[2], (FakeMemory::Access{12, 8320, false}));
}

// 16x16 words of 2 bytes are 8 lines, of 1 byte 4.
TEST_P(LiUpdateTest, TheClearWritesEveryLine) {
  config.clear = Clear::write;
  three_pass = true;
  run({});
  ASSERT_EQ(around.memory.accesses.size(), 12U);
  EXPECT_EQ(around.memory.accesses[0], (FakeMemory::Access{1, 8192, true}));
  EXPECT_EQ(around.memory.accesses[7], (FakeMemory::Access{8, 8192 + 448, true}));
  EXPECT_EQ(around.memory.accesses[8], (FakeMemory::Access{9, 12288, true}));
  EXPECT_EQ(around.memory.accesses[11], (FakeMemory::Access{12, 12288 + 192, true}));
}

// In three-pass an umbra polygon changes the stencil. The barrier waits for the fill (12) and the
// words (15).
TEST_P(LiUpdateTest, ABarrierIsThroughWhenNothingIsUnderWay) {
  three_pass = true;
  run({{0, tile_token(0, 0, {{0, 0, 0, 1, 0, 1}})}, {0, mark(Token::Kind::barrier)}});
  EXPECT_EQ(around.memory.accesses[0], (FakeMemory::Access{2, 12288, false}));
  EXPECT_EQ(drained, 15U);
}

// Of two blocks the stencil is read, in 2 and 3; the second holds something: its 2 lines of LI in 4
// and 5. Only LI is dirty then.
TEST_P(LiUpdateTest, TheMergeReadsTheStencilAndChangesLi) {
  three_pass = true;
  PrimitiveWork* const work = wedge_work(0, {});
  work->merged = {{0, 0, false}, {1, 0, true}};
  run({{0, {Token::Kind::merge, 0, work}}});
  EXPECT_EQ(around.memory.accesses, (Accesses{{2, 12288, false},
                                              {3, 12352, false},
                                              {4, 8320, false},
                                              {5, 8384, false},
                                              {19, 8320, true},
                                              {20, 8384, true}}));
}

WEDGESIM_BOTH_TIMINGS(LiUpdateTest);

}  // namespace
}  // namespace wedgesim::model::units::test
