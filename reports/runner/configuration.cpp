#include "reports/runner/configuration.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <set>

#include "base/error.h"
#include "model/block/config_keys.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

using model::BlockConfig;

constexpr std::array<std::string_view, 2> kMeasures{"count", "cycles"};
// What names a set of keys: kept as words beside the keys, for tables.
constexpr std::array<std::string_view, 2> kNames{"preset", "memory.dram.preset"};

std::string dotted(std::string_view section, std::string_view key) {
  return fmt::format("{}.{}", section, key);
}

template <typename E>
Value word(E value) {
  return std::string(model::spelling(value));
}

void add_formats(const BlockConfig& config, Values& values) {
  model::datapath::Formats formats = config.formats;
  for (const auto& width : model::datapath::kWidths) {
    values[dotted("formats", width.key)] = std::int64_t{width.of(formats)};
  }
}

void add_rasterizer(const model::CountConfig& r, Values& values) {
  values["block.mode"] = word(r.mode);
  values["block.tile"] = std::int64_t{r.tile};
  values["block.cull"] = word(r.cull);
  values["block.umbra_cull"] = word(r.umbra_cull);
  values["block.accept"] = word(r.accept);
  values["block.share"] = word(r.share);
  values["block.z"] = word(r.z);
  values["block.tile_build"] = word(r.tile_build);
}

void add_timing(BlockConfig config, Values& values) {
  const bool dram = config.memory.kind == model::MemoryKind::dram;
  for (const model::BlockKey& key : model::kBlockKeys) {
    if (dram && key.section == "memory") continue;  // of the ideal memory
    values[dotted(key.section, key.key)] = std::int64_t{key.of(config)};
  }
  values["li_update.clear"] = word(config.li_update.clear);
  values["memory.kind"] = word(config.memory.kind);
  if (!dram) return;
  for (const model::memory::DramKey& key : model::memory::kDramKeys) {
    values[dotted("memory.dram", key.key)] = std::int64_t{config.memory.dram.*key.value};
  }
}

Values effective_values(const Configuration& configuration) {
  Values values;
  add_rasterizer(configuration.block.rasterizer, values);
  if (configuration.measure == Measure::cycles) {
    add_timing(configuration.block, values);
    add_formats(configuration.block, values);
  } else {
    values["datapath"] = word(configuration.datapath);
    if (configuration.datapath == model::DatapathKind::fixed) {
      add_formats(configuration.block, values);
    }
  }
  return values;
}

// A block's configuration file with one setting a line.
struct BlockText {
  std::string text;
  std::vector<const Setting*> lines;
};

BlockText block_text(const Settings& settings) {
  BlockText block;
  const auto add = [&block](std::string_view key, const Value& value, const Setting* setting) {
    block.text += fmt::format("{} = {}\n", key, to_json(value).dump());
    block.lines.push_back(setting);
  };
  std::set<std::string_view> seen{"datapath"};
  for (auto setting = settings.rbegin(); setting != settings.rend(); ++setting) {
    if (seen.insert(setting->key).second) add(setting->key, setting->value, &*setting);
  }
  if (!seen.contains("preset")) add("preset", std::string("paper2-single"), nullptr);
  return block;
}

// parse_block's errors name a line of its text; the user knows the line of the study.
[[noreturn]] void rethrow_at_setting(const InputError& error, const std::string& file,
                                     const BlockText& block) {
  const std::string what = error.what();
  std::size_t line = 0;
  const char* begin = what.data() + std::min(what.size(), file.size() + 1);
  const char* end = what.data() + what.size();
  const auto [rest, failure] = std::from_chars(begin, end, line);
  if (failure != std::errc{} || line == 0 || line > block.lines.size() ||
      block.lines[line - 1] == nullptr) {
    throw error;
  }
  const Setting& setting = *block.lines[line - 1];
  const std::string_view problem(std::min(rest + 2, end), end);  // behind ": "
  throw InputError(fmt::format("{}:{}: {}", file, setting.line, setting.key), problem);
}

BlockConfig read_block(const std::string& file, const Settings& settings) {
  const BlockText block = block_text(settings);
  try {
    BlockConfig config = model::parse_block(block.text, file);
    config.name = "";
    return config;
  } catch (const InputError& error) {
    rethrow_at_setting(error, file, block);
  }
}

void require_effect(const std::string& file, const Configuration& configuration,
                    const Setting& setting) {
  if (configuration.values.contains(setting.key)) return;
  const bool timing = configuration.measure == Measure::count && setting.key != "datapath";
  if (configuration.measure == Measure::cycles && setting.key != "datapath") return;
  throw InputError(
      fmt::format("{}:{}: {}", file, setting.line, setting.key),
      fmt::format("has no effect on what '{}' measures", spelling(configuration.measure)),
      timing ? "a key of [block] or, with datapath = \"fixed\", of [formats]"
             : "a study that counts");
}

}  // namespace

std::string_view spelling(Measure measure) { return kMeasures[static_cast<std::size_t>(measure)]; }

Measure parse_measure(const std::string& place, std::string_view text) {
  const auto* found = std::ranges::find(kMeasures, text);
  if (found == kMeasures.end()) {
    throw InputError(place, fmt::format("'measure' is '{}'", text), "count or cycles");
  }
  return static_cast<Measure>(found - kMeasures.begin());
}

model::Datapath Configuration::count_datapath() const {
  model::Datapath chosen(datapath);
  chosen.formats = block.formats;
  return chosen;
}

Configuration make_configuration(const std::string& file, Measure measure, const Settings& settings,
                                 std::size_t shared) {
  Configuration configuration;
  configuration.measure = measure;
  configuration.block = read_block(file, settings);
  for (const Setting& setting : settings) {
    if (setting.key != "datapath") continue;
    configuration.datapath = model::parse<model::DatapathKind>(
        fmt::format("{}:{}: datapath", file, setting.line), to_text(setting.value));
  }
  configuration.values = effective_values(configuration);
  for (std::size_t i = 0; i < settings.size(); ++i) {
    const Setting& setting = settings[i];
    if (std::ranges::find(kNames, setting.key) != kNames.end()) {
      configuration.values[setting.key] = setting.value;
    } else if (i >= shared) {
      require_effect(file, configuration, setting);
    }
  }
  return configuration;
}

std::string point_key(const Configuration& configuration, std::uint64_t checksum) {
  return hash_of(fmt::format("{} {} {:016x}", spelling(configuration.measure),
                             to_json(configuration.values).dump(), checksum));
}

std::vector<std::string> differing_keys(const std::vector<Configuration>& configurations,
                                        const std::vector<std::string>& order) {
  std::vector<std::string> keys;
  for (const std::string& key : order) {
    if (std::ranges::find(keys, key) != keys.end()) continue;
    const bool differs =
        std::ranges::any_of(configurations, [&](const Configuration& configuration) {
          return find_value(configuration.values, key) !=
                 find_value(configurations.front().values, key);
        });
    if (differs) keys.push_back(key);
  }
  return keys;
}

}  // namespace wedgesim::reports
