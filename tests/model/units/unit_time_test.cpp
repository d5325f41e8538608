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
      time.sync(0);
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

// Three units that sync in cycle 5, made in another order than that of their turns.
TEST_P(UnitTimeTest, TurnsOrderWhatHappensInACycle) {
  const ScopedSimulation simulation;
  std::string order;
  const auto with_turn = [&](unsigned turn) {
    return [&, turn](UnitTime& time) {
      time.work(5);
      EXPECT_EQ(time.sync(turn) / kResolutionsPerCycle, 5U);
      order += std::to_string(turn);
      time.work(1);
      EXPECT_EQ(time.sync(9 - turn) / kResolutionsPerCycle, 6U);
      order += std::to_string(9 - turn);
    };
  };
  const Actor a("a", GetParam(), with_turn(4));
  const Actor b("b", GetParam(), with_turn(0));
  const Actor c("c", GetParam(), with_turn(2));
  sc_core::sc_start();
  EXPECT_EQ(order, "024579");
}

TEST_P(UnitTimeTest, AUnitThatMemoryHoldsIsStalled) {
  act([](UnitTime& time) {
    time.work(2);
    time.sync(0);
    const Cycle before = kernel_cycle();
    sc_core::wait(cycles_to_time(6));
    time.was_held(6);
    EXPECT_EQ(time.now(), 8U);
    time.work(1);
    EXPECT_EQ(kernel_cycle(), before + (GetParam() == Timing::clocked ? 7 : 6));
  });
  EXPECT_EQ(now, 9U);
  EXPECT_EQ(stalled, 6U);
  EXPECT_EQ(memory, 6U);
}

WEDGESIM_BOTH_TIMINGS(UnitTimeTest);

}  // namespace
}  // namespace wedgesim::model::units::test
