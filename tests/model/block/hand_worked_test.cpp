// Does a tiny frame take the cycles that a walk through the units by hand gives?
#include <gtest/gtest.h>

#include "tests/model/block/frames.h"
#include "tests/model/units/work.h"

namespace wedgesim::model {
namespace {

using units::PrimitiveWork;
using units::test::block_work;
using units::test::first_pixels;
using units::test::walked_tile;
using units::test::wedge_work;

// A memory that answers in the next cycle, queues that never fill, the rest as in the presets: a
// cycle from unit to unit, 24 through the penumbra pipeline, 4 lanes, 3 cycles for an update.
BlockConfig quick() {
  BlockConfig config;
  config.memory.ideal = {0, 65536};
  for (units::LinkConfig* queue : test::queues(config)) queue->depth = 1024;
  config.li_update.clear = units::Clear::none;
  return config;
}

// 20 pixels of one block: 2 lines of depth, 1 of LI. The record is 2 lines; 4 planes, 8 edges.
PrimitiveWork wedge(std::uint32_t index) {
  return *wedge_work(index, {walked_tile(0, {block_work(0, 0, first_pixels(20))})});
}

struct Expected {
  const char* name;
  memory::Cycle busy, stalled;
};

void expect(const std::vector<PrimitiveWork>& works, memory::Cycle cycles,
            const std::vector<Expected>& expected) {
  const RecordedFrame frame = test::frame_of(works);
  for (const auto timing : {units::Timing::decoupled, units::Timing::clocked}) {
    BlockOptions options;
    options.timing = timing;
    const BlockResult result = run_block(frame, quick(), options);
    EXPECT_EQ(result.cycles, cycles);
    ASSERT_EQ(result.units.size(), expected.size());
    for (std::size_t i = 0; i < expected.size(); ++i) {
      const UnitResult& unit = result.units[i];
      EXPECT_EQ(unit.name, expected[i].name);
      EXPECT_EQ(unit.busy, expected[i].busy) << unit.name;
      EXPECT_EQ(unit.stalled, expected[i].stalled) << unit.name;
      EXPECT_LE(unit.busy, result.cycles);
    }
  }
}

// unit         takes it  works until  the next sees it
// wedge_fetch  0         2            3 (lines asked for in 1 and 2, there in 2 and 3)
// wedge_setup  3         15           16
// tile_walk    16        17           18
// tile_cull    18        19           20
// z_read       20        22           23 (lines in 21 and 22)
// penumbra     23        28           52
// li_update    52        53 (its line is there in 54, its words are written in 57)
// The end follows a cycle behind, is seen in 53, waits for the line in 54 and for the words in 57;
// the line leaves in 58 and is taken in 59. Units of a pipeline take a cycle for the end.
TEST(HandWorked, OneWedge) {
  expect({wedge(0)}, 59,
         {{"wedge_fetch", 2, 0},
          {"wedge_setup", 13, 0},
          {"tile_walk", 2, 0},
          {"tile_cull", 2, 0},
          {"z_read", 3, 0},
          {"penumbra", 6, 0},
          {"li_update", 5, 1}});
}

// The second: fetched in 3 and 4; set up from 15 to 27; walked from 28 to 29; culled from 30 to 31,
// its tile's depths at hand; its depth looked up from 32 to 34, at hand; through the datapath from
// 35 to 40; updated from 64 to 65, written in 68; the line leaves in 69 and is taken in 70.
TEST(HandWorked, TwoWedges) {
  expect({wedge(0), wedge(1)}, 70,
         {{"wedge_fetch", 4, 0},
          {"wedge_setup", 25, 0},
          {"tile_walk", 3, 0},
          {"tile_cull", 3, 0},
          {"z_read", 5, 0},
          {"penumbra", 11, 0},
          {"li_update", 6, 0}});
}

}  // namespace
}  // namespace wedgesim::model
