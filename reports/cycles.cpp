#include "reports/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "reports/picture.h"
#include "reports/port_profile.h"

namespace wedgesim::reports {
namespace {

using model::BlockResult;
using Clock = std::chrono::steady_clock;

double seconds_since(Clock::time_point start) {
  return std::chrono::duration<double>(Clock::now() - start).count();
}

// all_bytes, without what builds zmin and zmax: the block finds them built.
std::uint64_t datapath_bytes(const model::Counters& c, const model::memory::LayoutConfig& layout) {
  return c.all_bytes.value() -
         static_cast<std::uint64_t>(layout.z_bytes) * c.tile_build_reads.value();
}

// Depth read once, LI read and written once, where no design can do without.
std::uint64_t floor_bytes(const model::Counters& c, const model::memory::LayoutConfig& layout) {
  return static_cast<std::uint64_t>(layout.z_bytes) * c.z_reads_floor.value() +
         2 * static_cast<std::uint64_t>(layout.li_bytes) * c.li_writes_floor.value();
}

model::PixelCheck check_pixels(const traces::TraceView& trace, const model::RecordedFrame& frame,
                               const model::BlockConfig& config) {
  model::Datapath datapath(model::DatapathKind::fixed);
  datapath.formats = config.formats;
  const auto method = frame.z_fail ? model::ZMethod::fail : model::ZMethod::pass;
  model::PixelCheck check;
  check.tolerance = datapath.tolerance();
  const auto width = static_cast<int>(trace.header.width);
  for (std::size_t i = 0; i < frame.li().size(); ++i) {
    const auto pixel = static_cast<int>(i);
    const auto compared =
        model::compare_pixel(trace, method, pixel % width, pixel / width, frame.li()[i], datapath);
    if (!compared) continue;
    check.compared += 1;
    check.max_error = std::max(check.max_error, std::abs(compared->error));
    check.mismatched += model::matches(*compared, datapath) ? 0 : 1;
  }
  return check;
}

std::optional<std::uint64_t> statistic(const BlockResult& result, std::string_view name) {
  for (const model::Statistic& statistic : result.memory) {
    if (statistic.name == name) return statistic.value;
  }
  return {};
}

std::optional<double> fraction(std::uint64_t part, std::uint64_t whole) {
  if (whole == 0) return {};
  return static_cast<double>(part) / static_cast<double>(whole);
}

model::memory::EnergyCounts energy_counts(const CyclesReport& report) {
  const model::Counters& c = report.counters();
  model::memory::EnergyCounts counts;
  counts.datapath_words = c.z_reads.value() + c.tile_reads.value() + c.li_reads.value() +
                          c.stencil_reads.value() + c.li_writes.value() + c.merge_reads.value() +
                          c.merge_writes.value();
  for (const model::CacheResult& cache : report.result.caches) {
    if (cache.size_bytes > 0) counts.cache_accesses += cache.hits + cache.misses;
  }
  // An ideal memory moves the port's bytes and opens no rows.
  counts.dram_bytes = burst_bytes(report.result).value_or(report.result.port_bytes());
  counts.dram_activates = statistic(report.result, "row_misses").value_or(0) +
                          statistic(report.result, "row_conflicts").value_or(0);
  return counts;
}

// Cycles of the two units that take longer for some tiles than for others whatever memory does.
std::vector<std::uint64_t> tile_cycles_of(const model::RecordedFrame& frame, int lanes,
                                          std::size_t tiles) {
  std::vector<std::uint64_t> cycles(tiles);
  for (const auto& primitive : frame.work) {
    for (const auto& tile : primitive->tiles) {
      const auto wide = static_cast<unsigned>(lanes);
      cycles[tile.tile] += tile.visits + (tile.pixels + wide - 1) / wide;
    }
  }
  return cycles;
}

}  // namespace

CheckedFrame check_frame(const traces::TraceView& trace, const model::BlockConfig& config) {
  CheckedFrame checked;
  checked.trace = info_of(trace);
  const auto start = Clock::now();
  checked.frame = model::record_frame(trace, config);
  checked.seconds = seconds_since(start);
  checked.pixels = check_pixels(trace, checked.frame, config);
  return checked;
}

CyclesReport run_cycles(const CheckedFrame& checked, const model::BlockConfig& config,
                        const model::BlockOptions& options,
                        const model::memory::EnergyTable* energy) {
  const model::RecordedFrame& frame = checked.frame;
  CyclesReport report;
  report.trace = checked.trace;
  report.config = config;
  report.value_seconds = checked.seconds;
  const std::size_t tiles = frame.walk->datapath().depth().tile_count();
  PortProfile profile(tiles);
  model::BlockOptions profiled = options;
  profiled.listener = [&](const model::memory::MemoryRecord& record) {
    profile.add(record);
    if (options.listener) options.listener(record);
  };
  const auto replay = Clock::now();
  report.result = model::run_block(frame, config, profiled);
  report.seconds = seconds_since(replay);
  report.z_fail = frame.z_fail;
  report.frame = frame.walk;
  report.pixels = checked.pixels;
  report.datapath_bytes = datapath_bytes(frame.counters(), frame.layout);
  report.floor_bytes = floor_bytes(frame.counters(), frame.layout);
  report.peak_bytes_per_cycle = profile.peak_bytes_per_cycle();
  report.tile_bytes = profile.tile_bytes();
  report.tile_cycles = tile_cycles_of(frame, config.penumbra.lanes, tiles);
  if (energy != nullptr) {
    report.energy = model::memory::energy_of(*energy, energy_counts(report));
  }
  return report;
}

std::optional<double> hit_rate(const model::CacheResult& cache) {
  if (cache.size_bytes == 0) return {};
  return fraction(cache.hits, cache.hits + cache.misses);
}

std::optional<double> row_hit_rate(const BlockResult& result) {
  const std::uint64_t hits = statistic(result, "row_hits").value_or(0);
  return fraction(hits, hits + statistic(result, "row_misses").value_or(0) +
                            statistic(result, "row_conflicts").value_or(0));
}

std::optional<std::uint64_t> burst_bytes(const BlockResult& result) {
  return statistic(result, "row_hits") ? statistic(result, "bytes") : std::nullopt;
}

Rates rates_of(const CyclesReport& report) {
  const BlockResult& result = report.result;
  const auto cycles = static_cast<double>(std::max<model::memory::Cycle>(result.cycles, 1));
  const double hertz = 1e6 * report.config.clock_mhz;
  const auto bytes = static_cast<double>(result.port_bytes());
  Rates rates;
  rates.frames_per_second = hertz / cycles;
  rates.port_gb_per_second = bytes * rates.frames_per_second / 1e9;
  rates.busiest_gb_per_second = report.peak_bytes_per_cycle * hertz / 1e9;
  rates.peak_gb_per_second = result.peak_bytes_per_cycle * hertz / 1e9;
  rates.port_bytes_over_floor =
      bytes / static_cast<double>(std::max<std::uint64_t>(report.floor_bytes, 1));
  return rates;
}

bool held(const CyclesReport& report) { return report.pixels.mismatched == 0; }

std::string write_tile_maps(const std::string& prefix, const CyclesReport& report) {
  const auto width = static_cast<int>(report.trace.width);
  const auto height = static_cast<int>(report.trace.height);
  const auto tile = static_cast<int>(report.config.rasterizer.tile);
  const int across = (width + tile - 1) / tile;
  std::string scales;
  for (const auto& [name, tiles] : {std::pair{"_tile_bytes", &report.tile_bytes},
                                    std::pair{"_tile_cycles", &report.tile_cycles}}) {
    std::vector<float> pixels;
    for (int y = 0; y < height; ++y) {
      for (int x = 0; x < width; ++x) {
        const auto i = static_cast<std::size_t>(y / tile * across + x / tile);
        pixels.push_back(static_cast<float>((*tiles)[i]));
      }
    }
    const float most = std::max(1.0F, *std::max_element(pixels.begin(), pixels.end()));
    for (const char* kind : {".png", ".exr"}) {
      write_heat(prefix + name + kind, pixels, width, height, most);
    }
    scales += fmt::format("{}{}: from 0 to {:.0f}\n", prefix, name, most);
  }
  return scales;
}

}  // namespace wedgesim::reports
