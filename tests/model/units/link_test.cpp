// Is an item there exactly on time and a slot free exactly on time, in both ways of keeping time?
#include "model/units/link.h"

#include "tests/model/units/bench.h"

namespace wedgesim::model::units::test {
namespace {

using Items = std::vector<std::pair<Cycle, int>>;
using Cycles = std::vector<Cycle>;

struct LinkTest : BothTimings {
  // Runs a source and a sink; what happened when is in `pushed` and `popped`.
  void run(const LinkConfig& config, const Items& items, Cycle hold = 0, Cycle from = 0) {
    const ScopedSimulation simulation;
    Link<int> link("a to b", config);
    Source<int> source("a", GetParam(), link, items);
    Sink<int> sink("b", GetParam(), link, items.size(), hold, from);
    sc_core::sc_start();
    pushed = source.pushed;
    popped = sink.popped;
    got = sink.items;
    stalled = source.time().stalled();
    starved = sink.time().starved();
  }

  Cycles pushed, popped;
  std::vector<int> got;
  Cycle stalled = 0, starved = 0;
};

TEST_P(LinkTest, AnItemIsThereAfterTheLatencyAndNotBefore) {
  for (const int latency : {1, 2, 24, 500}) {
    run({8, latency}, {{7, 1}});
    EXPECT_EQ(popped, Cycles{7 + static_cast<Cycle>(latency)});
    EXPECT_EQ(starved, 7 + static_cast<Cycle>(latency));
    run({8, latency}, {{7, 1}}, 0, 6 + static_cast<Cycle>(latency));  // looks a cycle too early
    EXPECT_EQ(popped, Cycles{7 + static_cast<Cycle>(latency)});
    EXPECT_EQ(starved, 1U);
  }
}

// Depth 2, latency 1; all are offered in cycle 0. The first two go at once; the sink takes the
// first in 1 and works until 6: the third goes in 2, the fourth in 7 and so on.
TEST_P(LinkTest, ASlotIsFreeTheCycleAfterItsItemHasGone) {
  run({2, 1}, {{0, 1}, {0, 2}, {0, 3}, {0, 4}, {0, 5}}, 5);
  EXPECT_EQ(popped, (Cycles{1, 6, 11, 16, 21}));
  EXPECT_EQ(pushed, (Cycles{0, 0, 2, 7, 12}));
  EXPECT_EQ(stalled, 12U);
  EXPECT_EQ(got, (std::vector{1, 2, 3, 4, 5}));
}

// One item at a time: pushed, there `latency` later, its slot free the cycle after.
TEST_P(LinkTest, DepthOneHasOneItemUnderWay) {
  run({1, 1}, {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(pushed, (Cycles{0, 2, 4}));
  EXPECT_EQ(popped, (Cycles{1, 3, 5}));
  run({1, 500}, {{0, 1}, {0, 2}, {0, 3}});
  EXPECT_EQ(pushed, (Cycles{0, 501, 1002}));
  EXPECT_EQ(popped, (Cycles{500, 1001, 1502}));
}

// As many items as slots are under way in the pipeline: 4 in each 9 cycles.
TEST_P(LinkTest, ManySlotsHideTheLatency) {
  run({4, 8}, {{0, 0}, {1, 1}, {2, 2}, {3, 3}, {4, 4}, {5, 5}});
  EXPECT_EQ(pushed, (Cycles{0, 1, 2, 3, 9, 10}));
  EXPECT_EQ(popped, (Cycles{8, 9, 10, 11, 17, 18}));
}

/// Pushes three items in cycles 0, 1, 2, ready in 3, 40 and 20.
class LateSource final : public BlockUnit {
 public:
  LateSource(sc_core::sc_module_name name, Timing timing, Link<int>& out)
      : BlockUnit(name, timing), out_(out) {}

 private:
  void process() override {
    for (const Cycle ready : {3, 40, 20}) {
      out_.push(time_, static_cast<int>(ready), ready);
      time_.work(1);
    }
  }
  Link<int>& out_;
};

// Latency 5 is later than ready 3; ready 40 is later than 6; 20 keeps its place behind 40.
TEST_P(LinkTest, DataThatAreReadyLaterHoldTheQueue) {
  const ScopedSimulation simulation;
  Link<int> link("a to b", {8, 5});
  LateSource source("a", GetParam(), link);
  Sink<int> sink("b", GetParam(), link, 3);
  sc_core::sc_start();
  EXPECT_EQ(sink.popped, (Cycles{5, 40, 40}));
  EXPECT_EQ(sink.items, (std::vector{3, 40, 20}));
  EXPECT_EQ(link.size(), 0U);
}

// Pushed in 5, there in 8, its data in 20: 8 cycles without an item, 12 for memory. The account: 5
// cycles before the push, 3 in the queue, 12 for memory.
TEST_P(LinkTest, AnItemWhoseDataAreNotThereWaitsForMemory) {
  const ScopedSimulation simulation;
  Link<int> link("a to b", {8, 3});
  Actor source("a", GetParam(), [&](UnitTime& time) {
    time.work(5);
    link.push(time, 1, 20);
  });
  Sink<int> sink("b", GetParam(), link, 1, 2);
  source.time().place_at(0);
  sink.time().place_at(1);
  sc_core::sc_start();
  EXPECT_EQ(sink.popped, Cycles{20});
  EXPECT_EQ(sink.time().starved(), 8U);
  EXPECT_EQ(sink.time().stalled(), 12U);
  EXPECT_EQ(sink.time().memory(), 12U);
  const CriticalPath& path = sink.time().path();
  EXPECT_EQ(path.of(0, CriticalPath::Part::work), 5U);
  EXPECT_EQ(path.of(0, CriticalPath::Part::queue), 3U);
  EXPECT_EQ(path.of(0, CriticalPath::Part::memory), 12U);
  EXPECT_EQ(path.of(1, CriticalPath::Part::work), 2U);
  EXPECT_EQ(path.total(), sink.time().now());
}

WEDGESIM_BOTH_TIMINGS(LinkTest);

}  // namespace
}  // namespace wedgesim::model::units::test
