// Is the part that the block names as its bottleneck the one that, made faster, saves most?
#include <gtest/gtest.h>

#include <functional>
#include <map>
#include <numeric>

#include "tests/model/block/frames.h"

namespace wedgesim::model {
namespace {

/// A frame and a configuration, either of which a test changes.
struct Case {
  RecordedFrame frame;
  BlockConfig config;
};

const traces::Trace& trace() {
  static const traces::Trace trace =
      test::render("plain-columns", traces::fb::WedgeKind_coverage, {96, 64});
  return trace;
}

Case base() {
  static const traces::TraceView view = trace().view();
  BlockConfig config;
  config.li_update.clear = units::Clear::none;
  return {record_frame(view, config), config};
}

// What a tile's visits cost is no key: the recorded visits are.
void change_visits(RecordedFrame& frame, unsigned factor, unsigned divisor) {
  for (auto& primitive : frame.work) {
    auto changed = std::make_shared<units::PrimitiveWork>(*primitive);
    for (units::TileWork& tile : changed->tiles) {
      tile.visits =
          static_cast<decltype(tile.visits)>((tile.visits * factor + divisor - 1) / divisor);
    }
    primitive = changed;
  }
}

using Change = std::function<void(Case&)>;

// What makes a part twice as fast.
const std::map<std::string, Change>& improvements() {
  static const std::map<std::string, Change> all{
      {"wedge_setup",
       [](Case& c) {
         c.config.wedge_setup.cycles_a_plane /= 2;
         c.config.wedge_setup.cycles_an_edge /= 2;
       }},
      {"tile_walk", [](Case& c) { c.config.tile_walk.cycles_a_tile /= 2; }},
      {"tile_cull", [](Case& c) { change_visits(c.frame, 1, 2); }},
      {"penumbra", [](Case& c) { c.config.penumbra.lanes *= 2; }},
      {"memory", [](Case& c) { c.config.memory.ideal.latency_cycles /= 2; }},
      {"queue:penumbra", [](Case& c) { c.config.penumbra.out.latency_cycles /= 2; }},
  };
  return all;
}

// The improvement that a named part stands for: there is one memory.
std::string improvement_of(const std::string& part) {
  return part.starts_with("memory:") ? "memory" : part;
}

void expect_best(Case start, const std::string& name) {
  SCOPED_TRACE(name);
  start.config.tile_walk.cycles_a_tile *= 2;  // so that it can be halved
  start.config.wedge_setup.cycles_a_plane *= 2;
  start.config.wedge_setup.cycles_an_edge *= 2;
  const BlockResult result = run_block(start.frame, start.config);
  EXPECT_EQ(result.bottleneck().name, name);
  std::map<std::string, memory::Cycle> cycles;
  for (const auto& [part, improve] : improvements()) {
    Case faster = start;
    improve(faster);
    cycles[part] = run_block(faster.frame, faster.config).cycles;
  }
  ASSERT_TRUE(cycles.contains(improvement_of(name)));
  for (const auto& [part, of_part] : cycles) {
    EXPECT_LE(cycles.at(improvement_of(name)), of_part) << part << " of " << result.cycles;
  }
}

TEST(Bottleneck, LanesAreNamedWhereTheyBind) {
  Case start = base();
  start.config.penumbra.lanes = 1;
  start.config.memory.ideal.latency_cycles = 20;
  expect_best(start, "penumbra");
}

TEST(Bottleneck, SetupIsNamedWhereItBinds) {
  Case start = base();
  start.config.wedge_setup.cycles_a_plane = start.config.wedge_setup.cycles_an_edge = 20;
  expect_best(start, "wedge_setup");
}

TEST(Bottleneck, TheWalkIsNamedWhereItBinds) {
  Case start = base();
  start.config.tile_walk.cycles_a_tile = 16;
  expect_best(start, "tile_walk");
}

TEST(Bottleneck, CullingIsNamedWhereItBinds) {
  Case start = base();
  change_visits(start.frame, 30, 1);
  expect_best(start, "tile_cull");
}

// The units behind are idle meanwhile: no unit is busy for long.
TEST(Bottleneck, TheMemoryBehindFetchIsNamedWhereItBinds) {
  Case start = base();
  start.config.wedge_fetch.outstanding = 1;
  start.config.memory.ideal.latency_cycles = 400;
  expect_best(start, "memory:wedge_fetch");
}

TEST(Bottleneck, TheMemoryBehindZIsNamedWhereItBinds) {
  Case start = base();
  start.config.penumbra.lanes = 16;
  start.config.z_read.cache.size_bytes = 0;
  start.config.z_read.out.depth = 2;
  start.config.memory.ideal.latency_cycles = 300;
  expect_best(start, "memory:z_read");
}

// One item in a long pipeline.
TEST(Bottleneck, APipelineOfTooFewItemsIsNamed) {
  Case start = base();
  start.config.penumbra.out = {1, 200};
  expect_best(start, "queue:penumbra");
}

TEST(Bottleneck, ThePathAddsUpToTheCyclesInBothTimings) {
  const Case start = base();
  for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
    BlockConfig config = start.config;
    config.rasterizer.mode = mode;
    const traces::TraceView view = trace().view();
    const RecordedFrame frame = record_frame(view, config);
    BlockOptions clocked;
    clocked.timing = units::Timing::clocked;
    const BlockResult fast = run_block(frame, config);
    const BlockResult witness = run_block(frame, config, clocked);
    ASSERT_EQ(fast.critical_path.size(), witness.critical_path.size());
    memory::Cycle sum = 0;
    for (std::size_t i = 0; i < fast.critical_path.size(); ++i) {
      EXPECT_EQ(fast.critical_path[i].name, witness.critical_path[i].name);
      EXPECT_EQ(fast.critical_path[i].cycles, witness.critical_path[i].cycles)
          << fast.critical_path[i].name;
      sum += fast.critical_path[i].cycles;
    }
    EXPECT_EQ(sum, fast.cycles);
  }
}

}  // namespace
}  // namespace wedgesim::model
