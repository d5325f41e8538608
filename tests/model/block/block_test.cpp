// Do the units in time account for every cycle and every byte, the same in both ways of keeping
// time, and does a better block never take longer?
#include "model/block/block.h"

#include <gtest/gtest.h>

#include <map>

#include "tests/model/block/frames.h"

namespace wedgesim::model {
namespace {

using test::caches;
using test::queues;
using traces::fb::WedgeKind_coverage;
using traces::fb::WedgeKind_linear;

const traces::Trace& linear() {
  static const traces::Trace trace = test::render("plain-columns", WedgeKind_linear);
  return trace;
}
const traces::Trace& coverage() {
  static const traces::Trace trace = test::render("plain-columns", WedgeKind_coverage);
  return trace;
}
const traces::Trace& sphere() {
  static const traces::Trace trace = wedgesim::test::render(
      "plain-columns", WedgeKind_coverage, {96, 64}, functional::LightShape::sphere);
  return trace;
}
const traces::Trace& z_fail() {
  static const traces::Trace trace = test::render("eye-in-shadow", WedgeKind_coverage);
  return trace;
}

BlockConfig config_of(Mode mode) {
  return read_block(mode == Mode::single_pass ? "paper2-single" : "paper2-three");
}

// Timings of one rasterizer, by name.
std::map<std::string, BlockConfig> timings(const BlockConfig& base) {
  std::map<std::string, BlockConfig> all{{"default", base}};
  const auto vary = [&](const std::string& name) -> BlockConfig& {
    return all.emplace(name, base).first->second;
  };
  for (units::LinkConfig* queue : queues(vary("queues of one"))) queue->depth = 1;
  for (units::LinkConfig* queue : queues(vary("queues of one, 500 cycles long"))) *queue = {1, 500};
  for (memory::CacheConfig* cache : caches(vary("no caches"))) cache->size_bytes = 0;
  for (memory::CacheConfig* cache : caches(vary("caches of a line"))) *cache = {64, 64, 1};
  vary("latency 500").memory.ideal.latency_cycles = 500;
  vary("latency 0").memory.ideal.latency_cycles = 0;
  vary("a byte a cycle").memory.ideal.bytes_per_cycle = 1;
  vary("no clear").li_update.clear = units::Clear::none;
  vary("slow updates").li_update.update_cycles = 64;
  BlockConfig& narrow = vary("one under way");
  narrow.wedge_fetch.outstanding = narrow.tile_cull.outstanding = 1;
  narrow.z_read.outstanding = narrow.li_update.outstanding = 1;
  for (const int lanes : {1, 2, 8, 16}) {
    vary("lanes " + std::to_string(lanes)).penumbra.lanes = lanes;
  }
  for (const memory::DramPreset& preset : memory::dram_presets()) {
    BlockConfig& dram = vary(std::string(preset.name));
    dram.memory.kind = MemoryKind::dram;
    dram.memory.dram = preset.config;
  }
  return all;
}

// (a) The cycles of every unit are those of the run.
void expect_accounted(const BlockResult& result) {
  for (const UnitResult& unit : result.units) {
    EXPECT_EQ(unit.busy + unit.starved + unit.stalled, result.cycles) << unit.name;
    EXPECT_LE(unit.memory, unit.stalled) << unit.name;
    EXPECT_LE(unit.busy, result.cycles) << unit.name;
  }
}

const CacheResult& cache(const BlockResult& result, std::string_view name) {
  for (const CacheResult& each : result.caches) {
    if (each.name == name) return each;
  }
  throw std::out_of_range(std::string(name));
}
const TrafficResult& traffic(const BlockResult& result, memory::Surface surface) {
  return result.traffic.at(static_cast<std::size_t>(surface));
}

// Every number of a result.
std::vector<std::uint64_t> numbers(const BlockResult& result) {
  std::vector<std::uint64_t> all{result.cycles};
  for (const UnitResult& unit : result.units) {
    all.insert(all.end(), {unit.busy, unit.starved, unit.stalled, unit.memory});
    for (const Statistic& statistic : unit.statistics) all.push_back(statistic.value);
  }
  for (const CacheResult& each : result.caches) {
    all.insert(all.end(), {each.hits, each.misses, each.write_backs});
  }
  for (const TrafficResult& each : result.traffic) {
    all.insert(all.end(), {each.reads, each.writes, each.read_bytes, each.write_bytes});
  }
  for (const Statistic& statistic : result.memory) all.push_back(statistic.value);
  return all;
}

// (b) However time is kept, every number is the same.
void expect_same(const BlockResult& a, const BlockResult& b) {
  EXPECT_EQ(a.cycles, b.cycles);
  ASSERT_EQ(a.units.size(), b.units.size());
  for (std::size_t i = 0; i < a.units.size(); ++i) {
    for (std::size_t k = 0; k < a.units[i].statistics.size(); ++k) {
      EXPECT_EQ(a.units[i].statistics[k].value, b.units[i].statistics[k].value)
          << a.units[i].name << ' ' << a.units[i].statistics[k].name;
    }
  }
  EXPECT_EQ(numbers(a), numbers(b));
}

void expect_witnessed(const RecordedFrame& frame, const BlockConfig& config) {
  BlockOptions clocked;
  clocked.timing = units::Timing::clocked;
  const BlockResult fast = run_block(frame, config);
  const BlockResult witness = run_block(frame, config, clocked);
  expect_accounted(fast);
  expect_accounted(witness);
  expect_same(fast, witness);
}

TEST(Block, DecoupledTimeIsThatOfTheClockedWitness) {
  for (const traces::Trace* trace : {&linear(), &coverage(), &sphere(), &z_fail()}) {
    for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
      const BlockConfig base = config_of(mode);
      const traces::TraceView view = trace->view();
      const RecordedFrame frame = record_frame(view, base);
      EXPECT_EQ(frame.z_fail, trace == &z_fail());
      for (const auto& [name, config] : timings(base)) {
        SCOPED_TRACE(name + ", " + std::string(spelling(mode)) + ", " + trace->header.name);
        expect_witnessed(frame, config);
      }
    }
  }
}

TEST(Block, DecoupledTimeIsThatOfTheClockedWitnessInEveryTileSize) {
  for (const unsigned tile : {2U, 4U, 8U, 16U, 32U, 64U, 128U, 256U}) {
    for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
      SCOPED_TRACE(std::to_string(tile) + ' ' + std::string(spelling(mode)));
      BlockConfig config = config_of(mode);
      config.rasterizer.tile = tile;
      const traces::TraceView view = coverage().view();
      expect_witnessed(record_frame(view, config), config);
    }
  }
}

std::uint64_t statistic(const BlockResult& result, std::string_view unit, std::string_view name) {
  for (const UnitResult& each : result.units) {
    if (each.name != unit) continue;
    for (const Statistic& statistic : each.statistics) {
      if (statistic.name == name) return statistic.value;
    }
  }
  throw std::out_of_range(std::string(unit));
}

// Each visit that is counted is tested once, each z read goes through a lane once.
TEST(Block, UnitsDoTheWorkThatIsCounted) {
  for (const traces::Trace* trace : {&linear(), &coverage(), &sphere(), &z_fail()}) {
    for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
      for (const Accept accept : {Accept::none, Accept::zmin}) {
        SCOPED_TRACE(trace->header.name + ' ' + std::string(spelling(mode)));
        BlockConfig config = config_of(mode);
        config.rasterizer.accept = accept;
        const traces::TraceView view = trace->view();
        const RecordedFrame frame = record_frame(view, config);
        const BlockResult result = run_block(frame, config);
        const Counters& counters = frame.counters();
        EXPECT_EQ(statistic(result, "tile_cull", "visits"), counters.tile_visits.value());
        const std::uint64_t pixels = statistic(result, "penumbra", "pixels");
        const bool unread = frame.z_fail || accept != Accept::none;  // caps, or accepted tiles
        if (unread) {
          EXPECT_GE(pixels, counters.z_reads.value());
        } else {
          EXPECT_EQ(pixels, counters.z_reads.value());
        }
      }
    }
  }
}

// A tile's word in memory holds what its tests name, in words of depth.
TEST(Block, TheLayoutKeepsTheTileWordsThatAreCounted) {
  const traces::TraceView view = coverage().view();
  for (const Cull cull : {Cull::none, Cull::zmax, Cull::both}) {
    for (const Accept accept : {Accept::none, Accept::zmin}) {
      BlockConfig config;
      config.rasterizer.cull = cull;
      config.rasterizer.umbra_cull = UmbraCull::none;
      config.rasterizer.accept = accept;
      const RecordedFrame frame = record_frame(view, config);
      const std::uint64_t bytes = 4 * frame.counters().tile_words.value();
      if (bytes == 0) continue;
      EXPECT_EQ(static_cast<std::uint64_t>(frame.layout.tile_bytes) * (96 / 8) * (64 / 8), bytes)
          << spelling(cull) << ' ' << spelling(accept);
    }
  }
}

TEST(Block, ARunLeavesNothingBehind) {
  const BlockConfig single = config_of(Mode::single_pass);
  const BlockConfig small = read_block("small");
  const traces::TraceView view = coverage().view();
  const RecordedFrame frame = record_frame(view, single);
  const auto before = numbers(run_block(frame, single));
  const auto other = numbers(run_block(frame, small));
  EXPECT_EQ(numbers(run_block(frame, single)), before);
  EXPECT_EQ(numbers(run_block(record_frame(view, single), single)), before);
  EXPECT_EQ(numbers(run_block(frame, small)), other);
  EXPECT_NE(other, before);
}

// (f)
TEST(Block, BytesAtThePortAreThoseOfTheRecordsAndOfTheCaches) {
  for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
    const BlockConfig base = config_of(mode);
    const traces::TraceView view = coverage().view();
    const RecordedFrame frame = record_frame(view, base);
    const memory::Layout layout(frame.layout);
    for (const auto& [name, config] : timings(base)) {
      SCOPED_TRACE(name + ", " + std::string(spelling(mode)));
      std::array<std::uint64_t, memory::kSurfaces> read{}, written{};
      memory::Cycle last = 0;
      std::size_t backwards = 0, outside = 0;
      BlockOptions options;
      options.listener = [&](const memory::MemoryRecord& record) {
        const auto surface = static_cast<std::size_t>(record.client);
        (record.write ? written : read)[surface] += record.bytes;
        backwards += record.cycle < last ? 1 : 0;
        last = record.cycle;
        const std::uint64_t base_address = layout.base(record.client);
        outside += record.address < base_address || record.address % 64 != 0 ||
                   record.address >= base_address + layout.bytes(record.client);
      };
      const BlockResult result = run_block(frame, config, options);
      EXPECT_EQ(backwards, 0U);
      EXPECT_EQ(outside, 0U);
      std::uint64_t sum = 0;
      for (std::size_t i = 0; i < memory::kSurfaces; ++i) {
        EXPECT_EQ(result.traffic[i].read_bytes, read[i]) << result.traffic[i].surface;
        EXPECT_EQ(result.traffic[i].write_bytes, written[i]) << result.traffic[i].surface;
        sum += read[i] + written[i];
      }
      EXPECT_EQ(result.port_bytes(), sum);
      const bool clears = config.li_update.clear == units::Clear::write;
      using memory::Surface;
      EXPECT_EQ(traffic(result, Surface::z).read_bytes, 64 * cache(result, "z_read").misses);
      EXPECT_EQ(traffic(result, Surface::z).writes, 0U);
      EXPECT_EQ(traffic(result, Surface::tile_depths).read_bytes,
                64 * cache(result, "tile_cull").misses);
      for (const auto& [surface, cache_name] :
           {std::pair{Surface::li, "li_update"}, {Surface::stencil, "li_update.stencil"}}) {
        if (surface == Surface::stencil && mode == Mode::single_pass) {
          EXPECT_EQ(traffic(result, surface).reads + traffic(result, surface).writes, 0U);
          continue;
        }
        EXPECT_EQ(traffic(result, surface).read_bytes, 64 * cache(result, cache_name).misses);
        const std::uint64_t cleared = clears ? (layout.bytes(surface) + 63) / 64 * 64 : 0;
        EXPECT_EQ(traffic(result, surface).write_bytes,
                  64 * cache(result, cache_name).write_backs + cleared);
      }
      EXPECT_EQ(traffic(result, Surface::wedges).writes, 0U);
    }
  }
}

// (e) 2 %: caches in one state or another when a pixel comes, and a memory that is asked in another
// order.
TEST(Block, MoreIsNeverSlower) {
  constexpr double kMargin = 1.02;
  const auto cycles = [](const RecordedFrame& frame, const BlockConfig& config) {
    return static_cast<double>(run_block(frame, config).cycles);
  };
  for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
    const BlockConfig base = config_of(mode);
    const traces::TraceView view = coverage().view();
    const RecordedFrame frame = record_frame(view, base);
    const auto expect_falling = [&](const std::string& what, const std::vector<int>& values,
                                    const std::function<void(BlockConfig&, int)>& set) {
      double before = 1e300;
      for (const int value : values) {
        BlockConfig config = base;
        set(config, value);
        const double now = cycles(frame, config);
        EXPECT_LE(now, kMargin * before) << what << ' ' << value << ' ' << spelling(mode);
        before = now;
      }
    };
    expect_falling("lanes", {1, 2, 4, 8, 16},
                   [](BlockConfig& c, int value) { c.penumbra.lanes = value; });
    expect_falling("latency", {1000, 500, 200, 100, 50, 0},
                   [](BlockConfig& c, int value) { c.memory.ideal.latency_cycles = value; });
    expect_falling("bytes a cycle", {1, 4, 16, 64, 256},
                   [](BlockConfig& c, int value) { c.memory.ideal.bytes_per_cycle = value; });
    expect_falling("queues", {1, 2, 4, 16, 64}, [](BlockConfig& c, int value) {
      for (units::LinkConfig* queue : queues(c)) queue->depth = value;
    });
    expect_falling("under way", {1, 2, 4, 16, 64}, [](BlockConfig& c, int value) {
      c.z_read.outstanding = c.li_update.outstanding = c.tile_cull.outstanding = value;
    });
    for (const std::size_t i : {0U, 1U, 2U, 3U}) {
      expect_falling("cache " + std::to_string(i), {0, 256, 1024, 4096, 16384},
                     [i](BlockConfig& c, int value) { caches(c)[i]->size_bytes = value; });
    }
  }
}

// Without wedges a frame still has its barriers and its merge.
TEST(Block, AFrameWithoutWedgesRunsThrough) {
  traces::Trace trace = coverage();
  trace.wedges.clear();
  trace.faces.clear();
  trace.umbra_polygons.clear();
  for (const Mode mode : {Mode::single_pass, Mode::three_pass}) {
    const BlockConfig config = config_of(mode);
    const traces::TraceView view = trace.view();
    const RecordedFrame frame = record_frame(view, config);
    expect_witnessed(frame, config);
    const BlockResult result = run_block(frame, config);
    EXPECT_EQ(traffic(result, memory::Surface::li).write_bytes, 96U * 64 * 2);
    EXPECT_EQ(traffic(result, memory::Surface::z).reads, 0U);
  }
}

}  // namespace
}  // namespace wedgesim::model
