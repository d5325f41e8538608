// Do misses overlap up to the limit, and do hits wait for a line that is on its way?
#include "model/units/line_reader.h"

#include "tests/model/units/bench.h"

namespace wedgesim::model::units::test {
namespace {

using Accesses = std::vector<FakeMemory::Access>;
constexpr AccessTag kTag{memory::Surface::z, memory::Cause::fill};

struct LineReaderTest : BothTimings {
  void act(const std::function<void(UnitTime&)>& action) {
    Actor actor("actor", GetParam(), action);
    sc_core::sc_start();
    ASSERT_TRUE(actor.finished());
    memory_cycles = actor.time().memory();
  }
  Surroundings around;
  Cycle memory_cycles = 0;
};

// Two under way, latency 10: those of cycles 1 and 2 are back in 11 and 12. The third is asked for
// in 3, leaves in 11, is back in 21; the fourth, asked for in 12, leaves at once.
TEST_P(LineReaderTest, AsManyAsAllowedAreUnderWay) {
  LineReader reader(around.port, {0, 64, 1}, 2, "x");
  act([&](UnitTime& time) {
    const Cycle expected[] = {11, 12, 21, 22};
    for (std::uint64_t i = 0; i < 4; ++i) {
      time.work(1);
      EXPECT_EQ(reader.read(time, kTag, 4096 + 64 * i), expected[i]);
    }
  });
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{1, 4096, false}, {2, 4160, false}, {11, 4224, false}, {12, 4288, false}}));
  EXPECT_EQ(memory_cycles, 8U);
}

TEST_P(LineReaderTest, AHitUnderAFillIsReadyWithIt) {
  LineReader reader(around.port, {256, 64, 4}, 1, "x");
  act([&](UnitTime& time) {
    time.work(1);
    EXPECT_EQ(reader.read(time, kTag, 4096), 11U);
    time.work(1);
    EXPECT_EQ(reader.read(time, kTag, 4096), 11U);
    EXPECT_EQ(time.now(), 2U);  // a hit never waits
    time.work(30);
    EXPECT_EQ(reader.read(time, kTag, 4096), 11U);
  });
  EXPECT_EQ(around.memory.accesses, (Accesses{{1, 4096, false}}));
  EXPECT_EQ(reader.cache().hits(), 2U);
  EXPECT_EQ(reader.cache().misses(), 1U);
}

TEST_P(LineReaderTest, AllCanBeWaitedForWhateverTheirOrder) {
  Outstanding outstanding(4);
  act([&](UnitTime& time) {
    outstanding.add(50);
    outstanding.add(20);
    outstanding.wait_for_one(time);
    EXPECT_EQ(time.now(), 0U);  // two places are left
    outstanding.wait_for_all(time);
    EXPECT_EQ(time.now(), 50U);
  });
  EXPECT_EQ(memory_cycles, 50U);
}

WEDGESIM_BOTH_TIMINGS(LineReaderTest);

}  // namespace
}  // namespace wedgesim::model::units::test
