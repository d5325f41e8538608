#include "reports/json.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/file.h"
#include "reports/accesses.h"

namespace wedgesim::reports {
namespace {

using model::CountConfig;

Json counters_json(const model::Counters& counters) {
  Json json = Json::object();
  for (const Counter* counter : counters.counters()) {
    json[std::string(counter->name())] = counter->value();
  }
  return json;
}

Json pixels_json(const model::PixelCheck& pixels) {
  Json worst = Json::array();
  for (const model::PixelError& pixel : pixels.worst) {
    worst.push_back({{"x", pixel.x},
                     {"y", pixel.y},
                     {"expected", pixel.expected},
                     {"li", pixel.li},
                     {"error", pixel.error},
                     {"sensitivity", pixel.sensitivity}});
  }
  return {{"compared", pixels.compared},
          {"max_error", pixels.max_error},
          {"rms_error", pixels.rms_error},
          {"rms_penumbra", pixels.rms_penumbra},
          {"mismatched", pixels.mismatched},
          {"tolerance", pixels.tolerance},
          {"worst", worst}};
}

// Only those of the fixed datapath may be chosen.
void add_formats(Json& configuration, const model::Datapath& datapath) {
  if (datapath.kind == model::DatapathKind::fixed)
    configuration["formats"] = to_json(datapath.formats);
}

// The distinct values of one option.
template <typename Value>
Json values_of(const std::vector<CountConfig>& configs, Value value) {
  Json values = Json::array();
  for (const CountConfig& config : configs) {
    const Json one = value(config);
    if (std::find(values.begin(), values.end(), one) == values.end()) values.push_back(one);
  }
  return values;
}

}  // namespace

TraceInfo info_of(const traces::TraceView& trace) {
  return {trace.header.name, trace.header.checksum, trace.header.width, trace.header.height,
          trace.wedges.size()};
}

Json to_json(model::datapath::Formats formats) {
  Json json = Json::object();
  for (const auto& width : model::datapath::kWidths) {
    json[std::string(width.key)] = width.of(formats);
  }
  return json;
}

Json to_json(const TraceInfo& trace) {
  return {{"name", trace.name},
          {"checksum", fmt::format("{:016x}", trace.checksum)},
          {"width", trace.width},
          {"height", trace.height},
          {"wedges", trace.wedges}};
}

Json to_json(const model::CountResult& result, const model::Datapath& datapath) {
  const CountConfig& config = result.config;
  return {{"mode", spelling(config.mode)},
          {"tile", config.tile},
          {"cull",
           {{"penumbra", spelling(config.cull)},
            {"umbra", spelling(config.umbra_cull)},
            {"accept", spelling(config.accept)}}},
          {"share", spelling(config.share)},
          {"z", result.z == model::ZMethod::pass ? "pass" : "fail"},
          {"tile_build", spelling(config.tile_build)},
          {"datapath", spelling(datapath.kind)},
          {"counters", counters_json(*result.counters)},
          {"totals",
           {{"accesses", accesses_of(result).total()},
            {"accesses_floor", floor_of(result)},
            {"all_bytes", result.counters->all_bytes.value()}}},
          {"pixels", pixels_json(result.pixels)},
          {"wrong_contributions", result.wrong_contributions},
          {"needless_visits", result.needless_visits},
          {"penumbra_z_reads", result.penumbra_z_reads},
          {"first_overflow", result.first_overflow ? Json(*result.first_overflow) : Json()},
          {"timing", {{"seconds", result.seconds}}}};
}

Json to_json(const std::vector<CountConfig>& configs, const model::Datapath& datapath) {
  const auto spelled = [&configs](auto CountConfig::*option) {
    return values_of(configs,
                     [option](const CountConfig& config) { return spelling(config.*option); });
  };
  Json json{{"mode", spelled(&CountConfig::mode)},
            {"tile", values_of(configs, [](const CountConfig& config) { return config.tile; })},
            {"cull", spelled(&CountConfig::cull)},
            {"umbra_cull", spelled(&CountConfig::umbra_cull)},
            {"accept", spelled(&CountConfig::accept)},
            {"share", spelled(&CountConfig::share)},
            {"z", spelled(&CountConfig::z)},
            {"tile_build", spelled(&CountConfig::tile_build)},
            {"datapath", spelling(datapath.kind)},
            {"needs", "all"}};  // no caster is left out yet
  add_formats(json, datapath);
  return json;
}

Json count_json(const TraceInfo& trace, const std::vector<model::CountResult>& results,
                const model::Datapath& datapath, std::span<const model::WedgeFlag> flagged) {
  std::vector<CountConfig> configs;
  Json entries = Json::array();
  for (const model::CountResult& result : results) {
    configs.push_back(result.config);
    entries.push_back(to_json(result, datapath));
  }
  Json flags = Json::array();
  for (const model::WedgeFlag& flag : flagged) {
    flags.push_back({{"wedge", flag.wedge}, {"reason", name(flag.reason)}, {"value", flag.value}});
  }
  return {{"schema", "wedgesim.count/1"},
          {"trace", to_json(trace)},
          {"configuration", to_json(configs, datapath)},
          {"flagged", std::move(flags)},
          {"configs", std::move(entries)}};
}

void write_json(const std::filesystem::path& path, const Json& json) {
  write_file(path, json.dump(1) + '\n');
}

}  // namespace wedgesim::reports
