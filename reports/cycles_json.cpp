#include <fmt/format.h>

#include "model/block/config_keys.h"
#include "reports/cycles.h"
#include "traces/format.h"

namespace wedgesim::reports {
namespace {

using model::BlockResult;

template <typename Value>
Json or_null(const std::optional<Value>& value) {
  return value ? Json(*value) : Json();
}

Json configuration_json(const model::BlockConfig& config) {
  model::BlockConfig values = config;
  const model::CountConfig& r = config.rasterizer;
  Json json{{"name", config.name}, {"hash", hash_of(config)}};
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
                      {"size_bytes", cache.size_bytes},
                      {"hits", cache.hits},
                      {"misses", cache.misses},
                      {"hit_rate", or_null(hit_rate(cache))},
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
          {"burst_bytes", or_null(burst_bytes(result))},
          {"floor_bytes", report.floor_bytes},
          {"peak_bytes_per_cycle", result.peak_bytes_per_cycle},
          {"busiest_bytes_per_cycle", report.peak_bytes_per_cycle},
          {"row_hit_rate", or_null(row_hit_rate(result))},
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

Json path_json(const BlockResult& result) {
  Json json = Json::object();
  for (const model::PathShare& part : result.critical_path) json[part.name] = part.cycles;
  return json;
}

Json rates_json(const CyclesReport& report) {
  const Rates rates = rates_of(report);
  return {{"clock_mhz", report.config.clock_mhz},
          {"frames_per_second", rates.frames_per_second},
          {"port_gb_per_second", rates.port_gb_per_second},
          {"busiest_gb_per_second", rates.busiest_gb_per_second},
          {"peak_gb_per_second", rates.peak_gb_per_second},
          {"port_bytes_over_floor", rates.port_bytes_over_floor}};
}

}  // namespace

std::string hash_of(const model::BlockConfig& config) {
  const std::string text = to_toml(config);
  return fmt::format("{:016x}", traces::checksum_of(std::as_bytes(std::span(text))));
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
          {"critical_path_cycles", path_json(report.result)},
          {"rates", rates_json(report)},
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

}  // namespace wedgesim::reports
