#include "reports/cycles.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "model/block/config_keys.h"
#include "reports/picture.h"
#include "reports/port_profile.h"
#include "reports/table.h"

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
  model::Datapath datapath(model::LiFormat::fixed);
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

std::uint64_t statistic(const BlockResult& result, std::string_view name) {
  for (const model::Statistic& statistic : result.memory) {
    if (statistic.name == name) return statistic.value;
  }
  return 0;
}

model::memory::EnergyCounts energy_counts(const CyclesReport& report) {
  const model::Counters& c = report.counters();
  model::memory::EnergyCounts counts;
  counts.datapath_words = c.z_reads.value() + c.tile_reads.value() + c.li_reads.value() +
                          c.stencil_reads.value() + c.li_writes.value() + c.merge_reads.value() +
                          c.merge_writes.value();
  for (const model::CacheResult& cache : report.result.caches) {
    counts.cache_accesses += cache.hits + cache.misses;
  }
  const bool dram = report.config.memory.kind == model::MemoryKind::dram;
  counts.dram_bytes = dram ? statistic(report.result, "bytes") : report.result.port_bytes();
  counts.dram_activates =
      statistic(report.result, "row_misses") + statistic(report.result, "row_conflicts");
  return counts;
}

// Cycles of the two units that take longer for some tiles than for others whatever memory does.
std::vector<std::uint64_t> tile_cycles_of(const model::RecordedFrame& frame, int lanes,
                                          std::size_t tiles) {
  std::vector<std::uint64_t> cycles(tiles);
  for (const auto& primitive : frame.work) {
    for (const auto& tile : primitive->tiles) {
      const unsigned pixels = tile.work.pixels();
      const auto wide = static_cast<unsigned>(lanes);
      cycles[tile.work.tile] += tile.work.visits + (pixels + wide - 1) / wide;
    }
  }
  return cycles;
}

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

Json configuration_json(const model::BlockConfig& config) {
  model::BlockConfig values = config;
  const model::CountConfig& r = config.rasterizer;
  Json json{{"name", config.name}};
  json["block"] = {{"mode", spelling(r.mode)},     {"tile", r.tile},
                   {"cull", spelling(r.cull)},     {"umbra_cull", spelling(r.umbra_cull)},
                   {"accept", spelling(r.accept)}, {"share", spelling(r.share)},
                   {"z", spelling(r.z)},           {"tile_build", spelling(r.tile_build)}};
  for (const model::BlockKey& key : model::kBlockKeys) {
    json[std::string(key.section)][std::string(key.key)] = key.of(values);
  }
  json["li_update"]["clear"] = model::spelling(config.li_update.clear);
  json["memory"]["kind"] = model::spelling(config.memory.kind);
  if (config.memory.kind == model::MemoryKind::dram) {
    for (const model::memory::DramKey& key : model::memory::kDramKeys) {
      json["memory"]["dram"][std::string(key.key)] = config.memory.dram.*key.value;
    }
  }
  json["formats"] = to_json(config.formats);
  return json;
}

Json units_json(const BlockResult& result) {
  Json units = Json::array();
  for (const model::UnitResult& unit : result.units) {
    Json json{{"name", unit.name},
              {"busy_cycles", unit.busy},
              {"starved_cycles", unit.starved},
              {"stalled_cycles", unit.stalled},
              {"memory_cycles", unit.memory}};
    for (const model::Statistic& statistic : unit.statistics) {
      if (!json.contains(statistic.name)) json[statistic.name] = statistic.value;
    }
    units.push_back(std::move(json));
  }
  return units;
}

Json memory_json(const CyclesReport& report) {
  const BlockResult& result = report.result;
  Json caches = Json::array();
  for (const model::CacheResult& cache : result.caches) {
    caches.push_back({{"name", cache.name},
                      {"hits", cache.hits},
                      {"misses", cache.misses},
                      {"write_backs", cache.write_backs}});
  }
  Json surfaces = Json::array();
  for (const model::TrafficResult& traffic : result.traffic) {
    surfaces.push_back({{"name", traffic.surface},
                        {"reads", traffic.reads},
                        {"writes", traffic.writes},
                        {"read_bytes", traffic.read_bytes},
                        {"write_bytes", traffic.write_bytes}});
  }
  Json memory = Json::object();
  for (const model::Statistic& statistic : result.memory) memory[statistic.name] = statistic.value;
  return {{"datapath_bytes", report.datapath_bytes},
          {"line_bytes", result.port_bytes()},
          {"floor_bytes", report.floor_bytes},
          {"peak_bytes_per_cycle", result.peak_bytes_per_cycle},
          {"busiest_bytes_per_cycle", report.peak_bytes_per_cycle},
          {"caches", caches},
          {"surfaces", surfaces},
          {"model", memory}};
}

Json energy_json(const CyclesReport& report) {
  if (!report.energy) return {};
  return {{"datapath", report.energy->datapath},
          {"caches", report.energy->cache},
          {"dram_bytes", report.energy->dram_bytes},
          {"dram_activates", report.energy->dram_activates},
          {"total", report.energy->total()}};
}

std::string row_of_rates(const CyclesReport& report) {
  const auto cycles = static_cast<double>(std::max<model::memory::Cycle>(report.result.cycles, 1));
  const double seconds = cycles / (1e6 * report.config.clock_mhz);
  const double bytes = static_cast<double>(report.result.port_bytes());
  return fmt::format(
      "{:.1f} frames/s and {:.2f} GB/s at {} MHz, {:.2f} GB/s asked for in the busiest {} cycles "
      "(the "
      "memory's "
      "peak is {:.1f}); {:.2f} bytes at the port for each byte that must move\n",
      1.0 / seconds, bytes / seconds / 1e9, report.config.clock_mhz,
      report.peak_bytes_per_cycle * report.config.clock_mhz / 1e3, PortProfile::kWindowCycles,
      report.result.peak_bytes_per_cycle * report.config.clock_mhz / 1e3,
      bytes / static_cast<double>(std::max<std::uint64_t>(report.floor_bytes, 1)));
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

Json cycles_json(const CyclesReport& report) {
  Json counters = Json::object();
  for (const Counter* counter : report.counters().counters()) {
    counters[std::string(counter->name())] = counter->value();
  }
  const auto& first = report.frame->datapath().first_overflow();
  return {{"schema", "wedgesim.cycles/1"},
          {"trace", to_json(report.trace)},
          {"configuration", configuration_json(report.config)},
          {"cycles", report.result.cycles},
          {"tile", report.config.rasterizer.tile},
          {"z", report.z_fail ? "fail" : "pass"},
          {"bottleneck", report.result.bottleneck().name},
          {"counters", counters},
          {"units", units_json(report.result)},
          {"memory", memory_json(report)},
          {"pixels",
           {{"compared", report.pixels.compared},
            {"max_error", report.pixels.max_error},
            {"mismatched", report.pixels.mismatched},
            {"tolerance", report.pixels.tolerance}}},
          {"first_overflow", first ? Json(*first) : Json()},
          {"energy_picojoules", energy_json(report)},
          {"timing", {{"value_seconds", report.value_seconds}, {"seconds", report.seconds}}}};
}

std::string cycles_text(const CyclesReport& report) {
  const BlockResult& result = report.result;
  std::string text = fmt::format(
      "{}: {}x{}, {} wedges; {}: {}, tile {}, z-{}\n\n{} cycles, the bottleneck is {}\n",
      report.trace.name, report.trace.width, report.trace.height, report.trace.wedges,
      report.config.name, spelling(report.config.rasterizer.mode), report.config.rasterizer.tile,
      report.z_fail ? "fail" : "pass", grouped(result.cycles), result.bottleneck().name);
  text += row_of_rates(report) + '\n';
  Table units;
  units.add_column("unit", Table::Align::left);
  for (const char* title : {"busy", "starved", "stalled", "on memory", "busy %"}) {
    units.add_column(title, Table::Align::right);
  }
  for (const model::UnitResult& unit : result.units) {
    units.add_row({unit.name, grouped(unit.busy), grouped(unit.starved), grouped(unit.stalled),
                   grouped(unit.memory), fmt::format("{:.1f}", percent(unit.busy, result.cycles))});
  }
  text += units.text() + '\n';
  Table caches;
  caches.add_column("cache", Table::Align::left);
  for (const char* title : {"hits", "misses", "hit %", "written back"}) {
    caches.add_column(title, Table::Align::right);
  }
  for (const model::CacheResult& cache : result.caches) {
    caches.add_row({cache.name, grouped(cache.hits), grouped(cache.misses),
                    fmt::format("{:.1f}", percent(cache.hits, cache.hits + cache.misses)),
                    grouped(cache.write_backs)});
  }
  text += caches.text() + '\n';
  Table bytes;
  bytes.add_column("bytes", Table::Align::left);
  for (const char* title : {"read", "written"}) bytes.add_column(title, Table::Align::right);
  for (const model::TrafficResult& traffic : result.traffic) {
    bytes.add_row({traffic.surface, grouped(traffic.read_bytes), grouped(traffic.write_bytes)});
  }
  text += bytes.text() + '\n';
  text += fmt::format("bytes: {} by the datapath, {} in cache lines at the port\n",
                      grouped(report.datapath_bytes), grouped(result.port_bytes()));
  Table memory;
  memory.add_column(fmt::format("memory ({})", spelling(report.config.memory.kind)),
                    Table::Align::left);
  memory.add_column("", Table::Align::right);
  memory.add_column("", Table::Align::left);
  for (const model::Statistic& statistic : result.memory) {
    memory.add_row({statistic.name, grouped(statistic.value), statistic.description});
  }
  text += '\n' + memory.text() + '\n';
  if (report.energy) {
    text += fmt::format(
        "energy: {:.2f} uJ a frame: datapath {:.2f}, caches {:.2f}, DRAM bytes {:.2f}, activates "
        "{:.2f}\n",
        report.energy->total() / 1e6, report.energy->datapath / 1e6, report.energy->cache / 1e6,
        report.energy->dram_bytes / 1e6, report.energy->dram_activates / 1e6);
  }
  if (const auto& first = report.frame->datapath().first_overflow()) {
    text += fmt::format("OVERFLOW: {} pixels, first {},{}\n",
                        grouped(report.counters().li_overflow_pixels.value()), (*first)[0],
                        (*first)[1]);
  }
  return text + fmt::format("pixels: {} compared; max error {:.2g}, {} mismatched\n",
                            grouped(report.pixels.compared), report.pixels.max_error,
                            grouped(report.pixels.mismatched));
}

}  // namespace wedgesim::reports
