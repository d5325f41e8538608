#include <fmt/format.h>

#include <algorithm>

#include "reports/cycles.h"
#include "reports/port_profile.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

using model::BlockResult;

double percent(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : 100.0 * static_cast<double>(part) / static_cast<double>(whole);
}

std::string percent_or_dash(const std::optional<double>& fraction) {
  return fraction ? fmt::format("{:.1f}", 100.0 * *fraction) : "-";
}

Table table(std::string name, std::initializer_list<const char*> numbers) {
  Table table;
  table.add_column(std::move(name), Table::Align::left);
  for (const char* title : numbers) table.add_column(title, Table::Align::right);
  return table;
}

// "memory:z_read" in words.
std::string spelled(const std::string& part) {
  const std::size_t colon = part.find(':');
  if (colon == std::string::npos) return part;
  return (part.starts_with("queue") ? "the queue behind " : "memory behind ") +
         part.substr(colon + 1);
}

// The parts that the frame's end waited for longest.
std::string path_text(const BlockResult& result) {
  std::vector<model::PathShare> parts = result.critical_path;
  std::stable_sort(parts.begin(), parts.end(),
                   [](const auto& a, const auto& b) { return a.cycles > b.cycles; });
  parts.resize(std::min<std::size_t>(parts.size(), 4));
  std::string text;
  for (const model::PathShare& part : parts) {
    text += fmt::format("{}{} {:.1f} %", text.empty() ? "waited for: " : ", ", spelled(part.name),
                        percent(part.cycles, result.cycles));
  }
  return text + '\n';
}

std::string head_text(const CyclesReport& report) {
  return fmt::format(
      "{}: {}x{}, {} wedges; {}: {}, tile {}, z-{}\n\n{} cycles, the bottleneck is {}\n",
      report.trace.name, report.trace.width, report.trace.height, report.trace.wedges,
      report.config.name, spelling(report.config.rasterizer.mode), report.config.rasterizer.tile,
      report.z_fail ? "fail" : "pass", grouped(report.result.cycles),
      spelled(report.result.bottleneck().name));
}

std::string rates_text(const CyclesReport& report) {
  const Rates rates = rates_of(report);
  return fmt::format(
      "{:.1f} frames/s and {:.2f} GB/s at {} MHz, {:.2f} GB/s asked for in the busiest {} cycles "
      "(the memory's peak is {:.1f}); {:.2f} bytes at the port for each byte that must move\n",
      rates.frames_per_second, rates.port_gb_per_second, report.config.clock_mhz,
      rates.busiest_gb_per_second, PortProfile::kWindowCycles, rates.peak_gb_per_second,
      rates.port_bytes_over_floor);
}

std::string units_text(const BlockResult& result) {
  Table units = table("unit", {"busy", "starved", "stalled", "on memory", "busy %"});
  for (const model::UnitResult& unit : result.units) {
    units.add_row({unit.name, grouped(unit.busy), grouped(unit.starved), grouped(unit.stalled),
                   grouped(unit.memory), fmt::format("{:.1f}", percent(unit.busy, result.cycles))});
  }
  return units.text();
}

std::string caches_text(const BlockResult& result) {
  Table caches = table("cache", {"bytes", "hits", "misses", "hit %", "written back"});
  for (const model::CacheResult& cache : result.caches) {
    caches.add_row({cache.name, grouped(cache.size_bytes), grouped(cache.hits),
                    grouped(cache.misses), percent_or_dash(hit_rate(cache)),
                    grouped(cache.write_backs)});
  }
  return caches.text();
}

// Each surface, then the three levels side by side.
std::string bytes_text(const CyclesReport& report) {
  Table bytes = table("bytes", {"read", "written"});
  for (const model::TrafficResult& traffic : report.result.traffic) {
    bytes.add_row({traffic.surface, grouped(traffic.read_bytes), grouped(traffic.write_bytes)});
  }
  std::string levels =
      fmt::format("bytes: {} in the datapath's words, {} in cache lines at the port",
                  grouped(report.datapath_bytes), grouped(report.result.port_bytes()));
  if (const auto bursts = burst_bytes(report.result)) {
    levels += fmt::format(", {} in DRAM bursts ({} % row hits)", grouped(*bursts),
                          percent_or_dash(row_hit_rate(report.result)));
  }
  return bytes.text() + '\n' + levels + '\n';
}

std::string memory_text(const CyclesReport& report) {
  Table memory = table(fmt::format("memory ({})", spelling(report.config.memory.kind)), {""});
  memory.add_column("", Table::Align::left);
  for (const model::Statistic& statistic : report.result.memory) {
    memory.add_row({statistic.name, grouped(statistic.value), statistic.description});
  }
  return memory.text();
}

std::string energy_text(const model::memory::Energy& energy) {
  return fmt::format(
      "energy: {:.2f} uJ a frame: datapath {:.2f}, caches {:.2f}, memory bytes {:.2f}, activates "
      "{:.2f}\n",
      energy.total() / 1e6, energy.datapath / 1e6, energy.cache / 1e6, energy.dram_bytes / 1e6,
      energy.dram_activates / 1e6);
}

std::string checks_text(const CyclesReport& report) {
  std::string text;
  if (const auto& first = report.frame->datapath().first_overflow()) {
    text = fmt::format("OVERFLOW: {} pixels, first {},{}\n",
                       grouped(report.counters().li_overflow_pixels.value()), (*first)[0],
                       (*first)[1]);
  }
  return text + fmt::format("pixels: {} compared; max error {:.2g}, {} mismatched\n",
                            grouped(report.pixels.compared), report.pixels.max_error,
                            grouped(report.pixels.mismatched));
}

}  // namespace

std::string cycles_text(const CyclesReport& report) {
  std::string text = head_text(report) + path_text(report.result) + rates_text(report);
  for (const std::string& table : {units_text(report.result), caches_text(report.result),
                                   bytes_text(report), memory_text(report)}) {
    text += '\n' + table;
  }
  text += '\n';
  if (report.energy) text += energy_text(*report.energy);
  return text + checks_text(report);
}

}  // namespace wedgesim::reports
