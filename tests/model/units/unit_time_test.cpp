// Is each cycle exactly one of busy, starved and stalled, and does time keep up with the kernel?
#include "model/units/unit_time.h"

#include "tests/model/units/bench.h"

namespace wedgesim::model::units::test {
namespace {

struct UnitTimeTest : BothTimings {
  void act(const std::function<void(UnitTime&)>& action) {
    const ScopedSimulation simulation;
    const Actor actor("actor", GetParam(), action);
    sc_core::sc_start();
    EXPECT_TRUE(actor.finished());
    const UnitTime& time = actor.time();
    now = time.now();
    busy = time.busy();
    starved = time.starved();
    stalled = time.stalled();
    memory = time.memory();
    EXPECT_EQ(busy + starved + stalled, now);
    kernel = kernel_cycle();
  }
  Cycle now = 0, busy = 0, starved = 0, stalled = 0, memory = 0, kernel = 0;
};

TEST_P(UnitTimeTest, EachCycleIsOneOfThree) {
  act([](UnitTime& time) {
    time.work(3);                    // 3
    time.starve_until(10);           // 7
    time.stall_until(12);            // 2
    time.wait_for_memory_until(20);  // 8, stalled
    time.work(0);
  });
  EXPECT_EQ(now, 20U);
  EXPECT_EQ(busy, 3U);
  EXPECT_EQ(starved, 7U);
  EXPECT_EQ(stalled, 10U);
  EXPECT_EQ(memory, 8U);
}

TEST_P(UnitTimeTest, WhatIsOverIsNotWaitedFor) {
  act([](UnitTime& time) {
    time.work(9);
    time.starve_until(9);
    time.stall_until(4);
    time.wait_for_memory_until(8);
  });
  EXPECT_EQ(now, 9U);
  EXPECT_EQ(busy, 9U);
  EXPECT_EQ(memory, 0U);
}

TEST_P(UnitTimeTest, OnlyAClockedUnitTakesTheKernelAlong) {
  act([](UnitTime& time) { time.work(5); });
  EXPECT_EQ(kernel, GetParam() == Timing::clocked ? 5U : 0U);
}

// What another process does in cycle 3 is before cycle 5, what it does in cycle 7 is not.
TEST_P(UnitTimeTest, WhatIsDueBeforeHappensBefore) {
  for (const auto& [due, expected] : {std::pair{3, "other unit"}, {7, "unit other"}}) {
    const ScopedSimulation simulation;
    std::string order;
    const Actor unit("unit", GetParam(), [&](UnitTime& time) {
      time.work(5);
      time.sync();
      order += order.empty() ? "unit" : " unit";
    });
    const Actor other("other", GetParam(), [&, cycles = due](UnitTime&) {
      sc_core::wait(cycles_to_time(static_cast<Cycle>(cycles)));
      order += order.empty() ? "other" : " other";
    });
    sc_core::sc_start();
    EXPECT_EQ(order, expected);
  }
}

// The kernel was at 0 or 2; a target lets it go on by 6.
TEST_P(UnitTimeTest, AKernelThatHasGoneOnIsCaughtUpWith) {
  act([](UnitTime& time) {
    time.work(2);
    const Cycle before = kernel_cycle();
    sc_core::wait(cycles_to_time(6));
    time.catch_up();
    time.catch_up();
    EXPECT_EQ(time.now(), before + 6);
    EXPECT_EQ(time.memory(), before + 4);
    time.work(1);
  });
  EXPECT_EQ(busy, 3U);
  EXPECT_EQ(stalled, memory);
}

WEDGESIM_BOTH_TIMINGS(UnitTimeTest);

}  // namespace
}  // namespace wedgesim::model::units::test
