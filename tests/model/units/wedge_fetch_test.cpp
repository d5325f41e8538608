// Which lines are fetched when, and when does a record go on? All with a memory of 10 cycles.
#include "model/units/wedge_fetch.h"

#include "tests/model/units/bench.h"
#include "tests/model/units/work.h"

namespace wedgesim::model::units::test {
namespace {

using Accesses = std::vector<FakeMemory::Access>;
using Cycles = std::vector<Cycle>;

PrimitiveWork* record(std::uint64_t offset, std::uint64_t bytes) {
  PrimitiveWork* const work = wedge_work(0, {});
  work->record_offset = offset;
  work->record_bytes = bytes;
  return work;
}

struct WedgeFetchTest : BothTimings {
  using Works = std::vector<const PrimitiveWork*>;

  static WedgeFetch::Source source(const Works& works) {
    return [works, next = std::size_t{0}]() mutable {
      return next < works.size() ? works[next++] : nullptr;
    };
  }
  // The records, then the mark of the end.
  void run(const Works& works, int outstanding = 32) {
    Link<Token> out("wedge_fetch to sink", {8, 1});
    WedgeFetch fetch("wedge_fetch", GetParam(), {outstanding, {}}, source(works), around.port,
                     around.layout, out);
    Sink<Token> sink("sink", GetParam(), out, works.size() + 1);
    sc_core::sc_start();
    ASSERT_TRUE(fetch.finished());
    EXPECT_EQ(sink.items.back().kind, Token::Kind::end);
    popped = sink.popped;
    popped.pop_back();
    busy = fetch.time().busy();
    memory_cycles = fetch.time().memory();
  }

  Surroundings around;
  Cycles popped;
  Cycle busy = 0, memory_cycles = 0;
};

// Lines in cycles 1 and 2, 3 and 4, back 10 later.
TEST_P(WedgeFetchTest, ALineACycle) {
  run({record(0, 128), record(128, 128)});
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{1, 0, false}, {2, 64, false}, {3, 128, false}, {4, 192, false}}));
  EXPECT_EQ(popped, (Cycles{12, 14}));
  EXPECT_EQ(busy, 4U);
}

// The second record begins in the line that the first ends in: one line more, in cycle 3.
TEST_P(WedgeFetchTest, ALineOfTwoRecordsIsFetchedOnce) {
  run({record(0, 96), record(96, 96)});
  EXPECT_EQ(around.memory.accesses, (Accesses{{1, 0, false}, {2, 64, false}, {3, 128, false}}));
  EXPECT_EQ(popped, (Cycles{12, 13}));
}

// Three records in one line, back in 11; each takes a cycle.
TEST_P(WedgeFetchTest, ARecordWithoutALineOfItsOwnTakesACycle) {
  run({record(0, 16), record(16, 16), record(32, 16)});
  EXPECT_EQ(around.memory.accesses, (Accesses{{1, 0, false}}));
  EXPECT_EQ(popped, (Cycles{11, 11, 11}));
  EXPECT_EQ(busy, 3U);
}

// The first line comes in 101, long after the second in 12.
TEST_P(WedgeFetchTest, ARecordWaitsForItsSlowestLine) {
  around.memory.latency = [](std::uint64_t address) { return address == 0 ? 100 : 10; };
  run({record(0, 128)});
  EXPECT_EQ(popped, Cycles{101});
}

// Two under way: the third leaves when the first is back, in 11, the fourth in 12.
TEST_P(WedgeFetchTest, NoMoreLinesThanAllowedAreUnderWay) {
  run({record(0, 256)}, 2);
  EXPECT_EQ(around.memory.accesses,
            (Accesses{{1, 0, false}, {2, 64, false}, {11, 128, false}, {12, 192, false}}));
  EXPECT_EQ(popped, Cycles{22});
  EXPECT_EQ(memory_cycles, 8U);
}

// Without wedges there is no memory of records either.
TEST_P(WedgeFetchTest, APolygonWithoutARecordTakesACycle) {
  memory::LayoutConfig config = Surroundings::config(8);
  config.wedge_bytes = 0;
  around.layout = memory::Layout(config);
  run({record(0, 0), record(0, 0)});
  EXPECT_TRUE(around.memory.accesses.empty());
  EXPECT_EQ(popped, (Cycles{2, 3}));
}

// The barrier goes in cycle 0 and is taken in 1; the block is empty 4 later, in 5. The first line
// is asked for at the end of 6, in 7.
TEST_P(WedgeFetchTest, ABarrierWaitsUntilTheBlockIsEmpty) {
  PrimitiveWork* const work = record(0, 64);
  work->barrier = true;
  Link<Token> out("wedge_fetch to sink", {8, 1});
  WedgeFetch fetch("wedge_fetch", GetParam(), {32, {}}, source({work}), around.port, around.layout,
                   out);
  const Actor last("last", GetParam(), [&](UnitTime& time) {
    EXPECT_EQ(out.pop(time).kind, Token::Kind::barrier);
    EXPECT_EQ(time.now(), 1U);
    time.work(4);
    fetch.drained(time.now());
    EXPECT_EQ(out.pop(time).kind, Token::Kind::work);
    EXPECT_EQ(time.now(), 17U);
    EXPECT_EQ(out.pop(time).kind, Token::Kind::end);
  });
  sc_core::sc_start();
  EXPECT_TRUE(last.finished());
  EXPECT_EQ(around.memory.accesses, (Accesses{{7, 0, false}}));
  EXPECT_EQ(fetch.time().starved(), 6U);
}

WEDGESIM_BOTH_TIMINGS(WedgeFetchTest);

}  // namespace
}  // namespace wedgesim::model::units::test
