#include "model/block/config.h"

#include <fmt/format.h>
#include <toml++/toml.h>

#include <bit>
#include <optional>

#include "base/error.h"
#include "base/file.h"
#include "base/toml_table.h"
#include "model/block/config_keys.h"

namespace wedgesim::model {
namespace {

// Without a fallback a missing key is an error.
template <typename Value>
std::optional<Value> fallback(bool complete, const Value& value) {
  return complete ? std::optional<Value>() : std::optional<Value>(value);
}

template <typename E>
void read_choice(const TomlTable& table, std::string_view key, bool complete, E& value) {
  const std::string text = table.text(key, fallback(complete, std::string(spelling(value))));
  value = parse<E>(table.place(key) + ": " + std::string(key), text);
}

void read_key(const TomlTable& table, const BlockKey& key, bool complete, BlockConfig& config) {
  int& value = key.of(config);
  value = table.integer(key.key, fallback(complete, value), key.low, key.high);
  const bool zero_is_allowed = key.low == 0;
  if (key.power_of_two && !(zero_is_allowed && value == 0) &&
      !std::has_single_bit(static_cast<unsigned>(value))) {
    table.fail(key.key, fmt::format("{} is no power of two", value),
               fmt::format("a power of two from {} to {}", key.low, key.high));
  }
}

void read_dram(const TomlTable& table, bool complete, MemoryConfig& config) {
  const bool is_dram = config.kind == MemoryKind::dram;
  if (table.has("dram")) {
    if (!is_dram)
      table.fail("dram", "means nothing to an ideal memory", "it only with kind = dram");
    const TomlTable dram = table.table("dram");
    config.dram = memory::read_dram(dram, config.dram, complete);
    dram.reject_unknown();
  } else if (is_dram && complete) {
    table.fail("dram", "is missing", "a table [memory.dram]");
  }
}

void read_section(const TomlTable& root, std::string_view section, bool complete,
                  BlockConfig& config) {
  if (!complete && !root.has(section)) return;
  const TomlTable table = root.table(section);
  for (const BlockKey& key : kBlockKeys) {
    if (key.section == section) read_key(table, key, complete, config);
  }
  CountConfig& rasterizer = config.rasterizer;
  if (section == "block") {
    read_choice(table, "mode", complete, rasterizer.mode);
    read_choice(table, "cull", complete, rasterizer.cull);
    read_choice(table, "umbra_cull", complete, rasterizer.umbra_cull);
    read_choice(table, "accept", complete, rasterizer.accept);
    read_choice(table, "share", complete, rasterizer.share);
    read_choice(table, "z", complete, rasterizer.z);
    read_choice(table, "tile_build", complete, rasterizer.tile_build);
    int tile = static_cast<int>(rasterizer.tile);
    tile = table.integer("tile", fallback(complete, tile), static_cast<int>(kMinTile),
                         static_cast<int>(kMaxTile));
    if (!std::has_single_bit(static_cast<unsigned>(tile))) {
      table.fail("tile", fmt::format("{} is no power of two", tile), "2, 4, 8, ... 256");
    }
    rasterizer.tile = static_cast<unsigned>(tile);
  }
  if (section == "li_update") read_choice(table, "clear", complete, config.li_update.clear);
  if (section == "memory") {
    read_choice(table, "kind", complete, config.memory.kind);
    read_dram(table, complete, config.memory);
  }
  table.reject_unknown();
}

void check_cache(const TomlTable& root, std::string_view section, std::string_view prefix,
                 const memory::CacheConfig& cache) {
  if (cache.size_bytes == 0 || cache.size_bytes >= 64 * cache.ways) return;
  const std::string place = root.place(section);
  if (cache.size_bytes < 64) {
    throw InputError(fmt::format("{}: {}.{}bytes", place, section, prefix),
                     fmt::format("{} bytes are less than a line", cache.size_bytes),
                     "0 for no cache, or a power of two from 64 to 67108864");
  }
  throw InputError(
      fmt::format("{}: {}.{}ways", place, section, prefix),
      fmt::format("{} ways of 64 bytes in a cache of {} bytes", cache.ways, cache.size_bytes),
      fmt::format("1 to {}", cache.size_bytes / 64));
}

BlockConfig preset(std::string_view name, std::string_view place) {
  BlockConfig config;
  config.name = name;
  if (name == "paper2-single") return config;
  if (name == "paper2-three") {
    config.rasterizer.mode = Mode::three_pass;
    return config;
  }
  if (name == "small") {
    config.clock_mhz = 300;
    config.penumbra.lanes = 1;
    config.tile_cull.cache.size_bytes = 512;
    config.z_read.cache.size_bytes = 1024;
    config.li_update.cache.size_bytes = 1024;
    config.li_update.stencil_cache.size_bytes = 512;
    config.z_read.outstanding = 4;
    config.li_update.outstanding = 4;
    config.li_update.outstanding_writes = 16;
    config.memory.kind = MemoryKind::dram;
    config.memory.dram = memory::dram_preset("lpddr4-3200", place);
    return config;
  }
  if (name == "wide") {
    config.clock_mhz = 1000;
    config.penumbra.lanes = 16;
    config.tile_cull.cache.size_bytes = 8192;
    config.z_read.cache.size_bytes = 65536;
    config.li_update.cache.size_bytes = 32768;
    config.li_update.stencil_cache.size_bytes = 16384;
    config.z_read.outstanding = 64;
    config.li_update.outstanding = 64;
    config.li_update.outstanding_writes = 256;
    config.memory.kind = MemoryKind::dram;
    config.memory.dram = memory::dram_preset("hbm2-2000", place);
    return config;
  }
  throw InputError(place, fmt::format("no configuration '{}'", name),
                   fmt::format("one of {}, or a .toml file", fmt::join(block_presets(), ", ")));
}

}  // namespace

std::vector<std::string_view> block_presets() {
  return {"paper2-single", "paper2-three", "small", "wide"};
}

BlockConfig parse_block(std::string_view text, const std::string& file) {
  const toml::table parsed = parse_toml(text, file);
  const TomlTable root(parsed, file);
  BlockConfig config;
  const bool complete = !root.has("preset");
  if (!complete) config = preset(root.text("preset"), root.place("preset") + ": preset");
  config.name = file;
  for (const std::string_view section : kBlockSections) {
    read_section(root, section, complete, config);
  }
  if (complete || root.has("formats")) {
    datapath::read_formats(root.table("formats"), complete, config.formats);
  }
  root.reject_unknown();
  check_cache(root, "tile_cull", "cache_", config.tile_cull.cache);
  check_cache(root, "z_read", "cache_", config.z_read.cache);
  check_cache(root, "li_update", "cache_", config.li_update.cache);
  check_cache(root, "li_update", "stencil_cache_", config.li_update.stencil_cache);
  return config;
}

BlockConfig read_block(const std::string& name_or_file) {
  const std::filesystem::path path(name_or_file);
  if (path.extension() != ".toml" && !path.has_parent_path()) {
    return preset(name_or_file, "--config");
  }
  const MappedFile mapped(path);
  return parse_block(mapped.text(), name_or_file);
}

std::string to_toml(const BlockConfig& config) {
  BlockConfig values = config;
  std::string text;
  const auto choice = [&text](std::string_view key, std::string_view value) {
    text += fmt::format("{} = \"{}\"\n", key, value);
  };
  for (const std::string_view section : kBlockSections) {
    text += fmt::format("{}[{}]\n", text.empty() ? "" : "\n", section);
    if (section == "block") {
      const CountConfig& r = config.rasterizer;
      choice("mode", spelling(r.mode));
      text += fmt::format("tile = {}\n", r.tile);
      choice("cull", spelling(r.cull));
      choice("umbra_cull", spelling(r.umbra_cull));
      choice("accept", spelling(r.accept));
      choice("share", spelling(r.share));
      choice("z", spelling(r.z));
      choice("tile_build", spelling(r.tile_build));
    }
    if (section == "li_update") choice("clear", spelling(config.li_update.clear));
    if (section == "memory") choice("kind", spelling(config.memory.kind));
    for (const BlockKey& key : kBlockKeys) {
      if (key.section == section) {
        text += fmt::format("{} = {}  # {}\n", key.key, key.of(values), key.what);
      }
    }
  }
  if (config.memory.kind == MemoryKind::dram) {
    text += "\n[memory.dram]\n";
    for (const memory::DramKey& key : memory::kDramKeys) {
      text += fmt::format("{} = {}  # {}\n", key.key, config.memory.dram.*key.value, key.what);
    }
  }
  text += "\n[formats]\n";
  for (const datapath::Width& width : datapath::kWidths) {
    text += fmt::format("{} = {}  # {}\n", width.key, width.of(values.formats), width.what);
  }
  return text;
}

}  // namespace wedgesim::model
