// Does every configuration print as a file that reads as the same, and is each mistake named?
#include "model/block/config.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <filesystem>

#include "base/file.h"
#include "model/block/config_keys.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::model {
namespace {

std::string replaced(std::string text, const std::string& line, const std::string& by) {
  const std::size_t at = text.find('\n' + line);
  EXPECT_NE(at, std::string::npos) << line;
  const std::size_t end = text.find('\n', at + 1);
  return text.replace(at + 1, end - at - 1, by);
}

// What reading a file says that changes the preset.
std::string error_of(const std::string& changes, const std::string& preset = "paper2-single") {
  return input_error_of([&] { parse_block("preset = \"" + preset + "\"\n" + changes, "b.toml"); });
}

TEST(BlockConfig, EveryPresetReadsAsItPrints) {
  for (const std::string_view name : block_presets()) {
    const BlockConfig config = read_block(std::string(name));
    EXPECT_EQ(config.name, name);
    const std::string text = to_toml(config);
    EXPECT_EQ(to_toml(parse_block(text, "b.toml")), text) << name;
  }
  EXPECT_EQ(read_block("paper2-three").rasterizer.mode, Mode::three_pass);
  EXPECT_EQ(read_block("small").memory.kind, MemoryKind::dram);
  EXPECT_EQ(read_block("wide").penumbra.lanes, 16);
}

// What docs/ says of a key is what the tables say.
TEST(BlockConfig, DocumentsHoldEveryKey) {
  std::vector<std::pair<std::string, std::string>> rows;  // page, row
  const auto range = [](int low, int high, bool power_of_two) {
    return fmt::format("{} to {}{}", low, high == 1 << 26 ? "2^26" : std::to_string(high),
                       power_of_two ? ", a power of two" : "");
  };
  BlockConfig config;
  for (const BlockKey& key : kBlockKeys) {
    if (key.section == "block") continue;  // no unit's
    const std::string unit = key.section == "memory" ? "memory_port" : std::string(key.section);
    rows.emplace_back("units/" + unit + ".md",
                      fmt::format("| `{}` | {} | {} | {} |", key.key, key.of(config),
                                  range(key.low, key.high, key.power_of_two), key.what));
  }
  for (const datapath::Width& width : datapath::kWidths) {
    rows.emplace_back("datapath.md", fmt::format("| `{}` | {} | {} | {} | {} |", width.key,
                                                 range(width.low, width.high, false),
                                                 width.of(config.formats), width.what, width.why));
  }
  for (const memory::DramKey& key : memory::kDramKeys) {
    rows.emplace_back("memory.md",
                      fmt::format("| `{}` | {} | {} |", key.key,
                                  range(key.low, key.high, key.power_of_two), key.what));
  }
  for (const auto& [page, row] : rows) {
    const MappedFile text(std::filesystem::path(WEDGESIM_SOURCE_DIR) / "docs" / page);
    EXPECT_TRUE(text.text().find(row) != std::string_view::npos) << page << " lacks " << row;
  }
}

// A table of DRAM keys changes the memory that the preset has.
TEST(BlockConfig, OneDramKeyLeavesTheOthers) {
  BlockConfig expected = read_block("wide");
  expected.memory.dram.queue_bursts = 3;
  const BlockConfig changed =
      parse_block("preset = \"wide\"\n[memory.dram]\nqueue_bursts = 3\n", "b.toml");
  EXPECT_EQ(to_toml(changed), to_toml(expected));
}

TEST(BlockConfig, WithoutAPresetADramNeedsOneOrEveryKey) {
  const std::string text = to_toml(read_block("wide"));
  const std::size_t begin = text.find("[memory.dram]\n") + 14;
  const std::string before = text.substr(0, begin);
  const std::string after = text.substr(text.find("\n[formats]"));
  EXPECT_NE(input_error_of([&] { parse_block(before + after, "b.toml"); }).find("'clock_mhz'"),
            std::string::npos);
  const BlockConfig named = parse_block(before + "preset = \"hbm2-2000\"\n" + after, "b.toml");
  EXPECT_EQ(to_toml(named), text);
}

// Each number is set to another of its range, alone, and comes back.
TEST(BlockConfig, EveryKeyIsReadIntoItsPlace) {
  for (const BlockKey& key : kBlockKeys) {
    BlockConfig expected;
    int& value = key.of(expected);
    value = value == key.high ? key.low : key.high;
    if (key.power_of_two && key.key.ends_with("ways")) value = 1;
    const std::string text = "preset = \"paper2-single\"\n[" + std::string(key.section) + "]\n" +
                             std::string(key.key) + " = " + std::to_string(value);
    EXPECT_EQ(to_toml(parse_block(text, "b.toml")), to_toml(expected)) << text;
  }
}

TEST(BlockConfig, EachKeyIsNeededWithoutAPreset) {
  const std::string text = to_toml(BlockConfig());
  for (const BlockKey& key : kBlockKeys) {
    // In its section: a key may be in several.
    const std::size_t section = text.find("[" + std::string(key.section) + "]");
    const std::string rest =
        replaced(text.substr(section), std::string(key.key) + " = ", "# left out");
    const std::string error =
        input_error_of([&] { parse_block(text.substr(0, section) + rest, "b.toml"); });
    EXPECT_NE(error.find("b.toml:"), std::string::npos) << error;
    EXPECT_NE(error.find(key.key), std::string::npos) << error;
  }
}

TEST(BlockConfig, NumbersOutOfRangeAreNamed) {
  for (const BlockKey& key : kBlockKeys) {
    for (const int value : {key.low - 1, key.high + 1}) {
      const std::string error = error_of("[" + std::string(key.section) + "]\n" +
                                         std::string(key.key) + " = " + std::to_string(value));
      EXPECT_NE(error.find("b.toml:3: '" + std::string(key.key) + "'"), std::string::npos)
          << key.key << ": " << error;
    }
  }
}

TEST(BlockConfig, WhatNoHardwareCanBeIsNamed) {
  const std::pair<const char*, const char*> mistakes[] = {
      {"[penumbra]\nlanes = 0", "'lanes'"},
      {"[penumbra]\nlanes = 3", "'lanes' 3 is no power of two"},
      {"[block]\ntile = 12", "'tile' 12 is no power of two"},
      {"[block]\ntile = 1", "'tile'"},
      {"[z_read]\ncache_bytes = 32", "z_read.cache_bytes: 32 bytes are less than a line"},
      {"[z_read]\ncache_bytes = 128", "z_read.cache_ways: 4 ways of 64 bytes in a cache of 128"},
      {"[li_update]\nstencil_cache_bytes = 64", "li_update.stencil_cache_ways"},
      {"[block]\nmode = \"two-pass\"", "mode"},
      {"[block]\ntiles = 8", "tiles"},
      {"[blocks]\ntile = 8", "blocks"},
      {"[memory]\nkind = \"flash\"", "kind"},
      {"[memory.dram]\nrp = 8", "it only with kind = dram"},
      {"[formats]\nform_bits = 23", "'form_bits'"},
      {"[formats]\nli_integer_bits = 1", "'li_integer_bits'"},
      {"[formats]\nwidth = 8", "width"},
      {"[block]\ntile = 8.5", "'tile'"},
      {"[block]\ntile = \"8\"", "'tile'"},
      {"[block", "b.toml:2"},
  };
  for (const auto& [text, part] : mistakes) {
    const std::string error = error_of(text);
    EXPECT_NE(error.find("b.toml:"), std::string::npos) << text << ": " << error;
    EXPECT_NE(error.find(part), std::string::npos) << text << ": " << error;
    EXPECT_EQ(error.find('\n'), std::string::npos) << error;
  }
  EXPECT_NE(error_of("", "huge").find("paper2-single"), std::string::npos);
  EXPECT_NE(input_error_of([] { read_block("huge"); }).find("no configuration 'huge'"),
            std::string::npos);
}

}  // namespace
}  // namespace wedgesim::model
