#include "reports/cycles.h"

#include <gtest/gtest.h>

#include <numeric>

#include "base/image.h"
#include "tests/base/temporary_folder.h"
#include "tests/support/render.h"

namespace wedgesim::reports {
namespace {

using model::BlockConfig;

const traces::Trace& frame() {
  static const traces::Trace trace =
      test::render("plain-columns", traces::fb::WedgeKind_coverage, {96, 64});
  return trace;
}

constexpr model::memory::EnergyTable kEach{1.0, 1.0, 1.0, 1.0};  // so energies are counts

CyclesReport run(const BlockConfig& config) {
  traces::Trace trace = frame();
  trace.expected_li.assign(trace.depth.size(), 1.0);
  const traces::TraceView view = trace.view();
  return run_cycles(check_frame(view, config), config, {}, &kEach);
}

BlockConfig ideal() { return model::read_block("paper2-single"); }
BlockConfig dram() { return model::read_block("small"); }

// 1000 cycles of 500 MHz are 2 us: 500,000 frames a second, 64,000 bytes each.
TEST(Cycles, RatesAreCountsAtTheBlocksClock) {
  CyclesReport report;
  report.config.clock_mhz = 500;
  report.result.cycles = 1000;
  report.result.traffic = {{"z", 500, 0, 32000, 0}, {"li", 0, 500, 0, 32000}};
  report.result.peak_bytes_per_cycle = 64.0;
  report.peak_bytes_per_cycle = 60.0;
  report.floor_bytes = 6400;
  const Rates rates = rates_of(report);
  EXPECT_DOUBLE_EQ(rates.frames_per_second, 5e5);
  EXPECT_DOUBLE_EQ(rates.port_gb_per_second, 32.0);
  EXPECT_DOUBLE_EQ(rates.busiest_gb_per_second, 30.0);
  EXPECT_DOUBLE_EQ(rates.peak_gb_per_second, 32.0);
  EXPECT_DOUBLE_EQ(rates.port_bytes_over_floor, 10.0);
  report.result.cycles = 0;
  report.floor_bytes = 0;
  EXPECT_TRUE(std::isfinite(rates_of(report).frames_per_second));
  EXPECT_TRUE(std::isfinite(rates_of(report).port_bytes_over_floor));
}

TEST(Cycles, HitRatesAreOfWhatIsThere) {
  EXPECT_EQ(hit_rate({"z_read", 4096, 3, 1, 0}), 0.75);
  EXPECT_EQ(hit_rate({"z_read", 4096, 0, 0, 0}), std::nullopt);
  EXPECT_EQ(hit_rate({"z_read", 0, 0, 7, 0}), std::nullopt);
  model::BlockResult result;
  EXPECT_EQ(row_hit_rate(result), std::nullopt);
  EXPECT_EQ(burst_bytes(result), std::nullopt);
  result.memory = {{"bytes", "", "", 320},
                   {"row_hits", "", "", 5},
                   {"row_misses", "", "", 3},
                   {"row_conflicts", "", "", 2}};
  EXPECT_EQ(row_hit_rate(result), 0.5);
  EXPECT_EQ(burst_bytes(result), 320U);
}

TEST(Cycles, ConfigurationsShareAHashIfTheyAreTheSame) {
  BlockConfig a = ideal();
  BlockConfig b = ideal();
  b.name = "another name";
  EXPECT_EQ(hash_of(a).size(), 16U);
  EXPECT_EQ(hash_of(a), hash_of(b));
  b.penumbra.lanes = 8;
  EXPECT_NE(hash_of(a), hash_of(b));
}

TEST(Cycles, JsonHasRatesWithUnitsInTheirNames) {
  const CyclesReport report = run(dram());
  const Json json = cycles_json(report);
  const Rates rates = rates_of(report);
  EXPECT_EQ(json["rates"]["clock_mhz"], 300);
  EXPECT_EQ(json["rates"]["frames_per_second"], rates.frames_per_second);
  EXPECT_EQ(json["rates"]["port_gb_per_second"], rates.port_gb_per_second);
  EXPECT_EQ(json["rates"]["busiest_gb_per_second"], rates.busiest_gb_per_second);
  EXPECT_EQ(json["rates"]["peak_gb_per_second"], rates.peak_gb_per_second);
  EXPECT_EQ(json["rates"]["port_bytes_over_floor"], rates.port_bytes_over_floor);
  EXPECT_EQ(json["memory"]["row_hit_rate"], *row_hit_rate(report.result));
  EXPECT_EQ(json["memory"]["burst_bytes"], json["memory"]["model"]["bytes"]);
  EXPECT_EQ(json["memory"]["caches"][1]["hit_rate"], *hit_rate(report.result.caches[1]));
  EXPECT_EQ(json["configuration"]["hash"], hash_of(report.config));
  const Json without = cycles_json(run(ideal()));
  EXPECT_TRUE(without["memory"]["row_hit_rate"].is_null());
  EXPECT_TRUE(without["memory"]["burst_bytes"].is_null());
}

// The block waits for lines of z behind which few items fit.
TEST(Cycles, TheBottleneckIsNamedInWordsAndInJson) {
  BlockConfig config = ideal();
  config.z_read.cache.size_bytes = 0;
  config.z_read.out.depth = 1;
  config.memory.ideal.latency_cycles = 1000;
  config.wedge_fetch.outstanding = 256;
  const CyclesReport report = run(config);
  const Json json = cycles_json(report);
  EXPECT_EQ(json["bottleneck"], "memory:z_read");
  std::uint64_t sum = 0;
  for (const Json& cycles : json["critical_path_cycles"]) sum += cycles.get<std::uint64_t>();
  EXPECT_EQ(sum, json["cycles"].get<std::uint64_t>());
  const std::string text = cycles_text(report);
  EXPECT_NE(text.find("the bottleneck is memory behind z_read\nwaited for: memory behind z_read "),
            std::string::npos)
      << text;
}

TEST(Cycles, TheTextHasThreeLevelsOfBytesSideBySide) {
  const std::string text = cycles_text(run(dram()));
  for (const char* part :
       {"frames/s", " in the datapath's words, ", " in cache lines at the port, ",
        " in DRAM bursts (", "% row hits)", "energy: "}) {
    EXPECT_NE(text.find(part), std::string::npos) << part << " is not in:\n" << text;
  }
  const std::string without = cycles_text(run(ideal()));
  EXPECT_EQ(without.find("DRAM"), std::string::npos);
}

// No cache costs nothing; an ideal memory moves the port's bytes and opens no rows.
TEST(Cycles, EnergyIsOfWhatIsThere) {
  BlockConfig config = ideal();
  config.z_read.cache.size_bytes = 0;
  const CyclesReport without_z = run(config);
  double lookups = 0.0;
  for (const model::CacheResult& cache : without_z.result.caches) {
    const auto all = static_cast<double>(cache.hits + cache.misses);
    if (cache.name == "z_read") {
      EXPECT_GT(all, 0.0);
    } else {
      lookups += all;
    }
  }
  EXPECT_EQ(without_z.energy->cache, lookups);
  EXPECT_EQ(without_z.energy->dram_bytes, static_cast<double>(without_z.result.port_bytes()));
  EXPECT_EQ(without_z.energy->dram_activates, 0.0);
  const CyclesReport with_dram = run(dram());
  EXPECT_EQ(with_dram.energy->dram_bytes, static_cast<double>(*burst_bytes(with_dram.result)));
  EXPECT_GT(with_dram.energy->dram_activates, 0.0);
}

// Whatever of the port names a tile is on the map; lanes make a tile's cycles fewer.
TEST(Cycles, TilesHaveTheirBytesAndCycles) {
  BlockConfig config = ideal();
  const CyclesReport wide = run(config);
  config.penumbra.lanes = 1;
  const CyclesReport narrow = run(config);
  ASSERT_EQ(wide.tile_bytes.size(), 12U * 8);
  const auto sum = [](const std::vector<std::uint64_t>& values) {
    return std::accumulate(values.begin(), values.end(), std::uint64_t{0});
  };
  EXPECT_GT(sum(wide.tile_bytes), 0U);
  EXPECT_LE(sum(wide.tile_bytes), wide.result.port_bytes());
  // With one lane, a tile's cycles are its visits and its pixels.
  std::uint64_t pixels = 0;
  for (const model::Statistic& statistic : narrow.result.units[5].statistics) {
    if (statistic.name == "pixels") pixels = statistic.value;
  }
  EXPECT_EQ(sum(narrow.tile_cycles), narrow.counters().tile_visits.value() + pixels);
  EXPECT_LT(sum(wide.tile_cycles), sum(narrow.tile_cycles));
}

// 20x10 pixels in tiles of 8: three tiles across, two down, the last ones in part.
TEST(Cycles, MapsHaveTilesAsLargeAsTheirPixels) {
  const TemporaryFolder folder;
  CyclesReport report;
  report.trace.width = 20;
  report.trace.height = 10;
  report.tile_bytes = {0, 64, 128, 192, 256, 320};
  report.tile_cycles = {6, 5, 4, 3, 2, 1};
  const std::string prefix = (folder / "map").string();
  const std::string scales = write_tile_maps(prefix, report);
  EXPECT_NE(scales.find("map_tile_bytes: from 0 to 320\n"), std::string::npos) << scales;
  EXPECT_NE(scales.find("map_tile_cycles: from 0 to 6\n"), std::string::npos) << scales;
  EXPECT_EQ(folder.entries(), 4U);
  const Image bytes = read_image(prefix + "_tile_bytes.exr");
  const Image cycles = read_image(prefix + "_tile_cycles.exr");
  ASSERT_EQ(bytes.width, 20);
  ASSERT_EQ(bytes.height, 10);
  for (int y = 0; y < 10; ++y) {
    for (int x = 0; x < 20; ++x) {
      const int tile = y / 8 * 3 + x / 8;
      EXPECT_EQ(bytes.pixel(x, y)[0], 64.0F * static_cast<float>(tile)) << x << ',' << y;
      EXPECT_EQ(cycles.pixel(x, y)[0], 6.0F - static_cast<float>(tile)) << x << ',' << y;
    }
  }
}

}  // namespace
}  // namespace wedgesim::reports
