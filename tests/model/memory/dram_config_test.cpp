#include "model/memory/dram_config.h"

#include <gtest/gtest.h>

#include "base/toml_table.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::model::memory {
namespace {

std::string error(int DramConfig::*key, int value) {
  DramConfig config;
  config.*key = value;
  return input_error_of([&] { check(config, "block.toml:5"); });
}

TEST(DramConfig, PresetsAreValidAndHaveTheirNamedRate) {
  for (const DramPreset& preset : dram_presets()) {
    EXPECT_NO_THROW(check(preset.config, preset.name));
    EXPECT_EQ(&dram_preset(preset.name, "x"), &preset.config);
  }
  // Data rate a pin x pins / 8: 2 x 16 pins of 3200, 2 x 16 of 14000, 16 x 64 of 2000 Mb/s.
  EXPECT_EQ(dram_preset("lpddr4-3200", "x").peak_bytes_per_second(), 12.8e9);
  EXPECT_EQ(dram_preset("gddr6-14000", "x").peak_bytes_per_second(), 56e9);
  EXPECT_EQ(dram_preset("hbm2-2000", "x").peak_bytes_per_second(), 256e9);
}

TEST(DramConfig, UnknownPresetNamesThoseThatExist) {
  EXPECT_EQ(input_error_of([] { dram_preset("ddr5", "block.toml:5"); }),
            "block.toml:5: unknown memory 'ddr5'; expected one of lpddr4-3200, gddr6-14000, "
            "hbm2-2000");
}

TEST(DramConfig, EveryKeyIsChecked) {
  for (const DramKey& key : kDramKeys) {
    EXPECT_NE(error(key.value, key.low - 1), "") << key.key;
    EXPECT_NE(error(key.value, key.high + 1), "") << key.key;
    if (key.power_of_two) {
      EXPECT_NE(error(key.value, 3), "") << key.key;
    }
  }
  EXPECT_EQ(error(&DramConfig::channels, 3),
            "block.toml:5: 'channels' is 3; expected a power of two from 1 to 128");
  EXPECT_EQ(error(&DramConfig::rp, 0),
            "block.toml:5: 'rp' is 0; expected an integer from 1 to 256");
}

TEST(DramConfig, KeysMustFitEachOther) {
  EXPECT_EQ(error(&DramConfig::bank_groups, 16),
            "block.toml:5: 'bank_groups' is 16; expected an integer from 1 to 8");
  EXPECT_EQ(error(&DramConfig::interleave_bytes, 16),
            "block.toml:5: 'interleave_bytes' is 16; expected an integer from 32 to 2048");
  EXPECT_EQ(error(&DramConfig::refi, 448),
            "block.toml:5: 'refi' is 448; expected an integer from 449 to 1000000");
}

DramConfig read(const std::string& text, bool complete = false) {
  const toml::table root = parse_toml(text, "block.toml");
  const TomlTable table(root, "block.toml");
  const DramConfig config = read_dram(table, dram_preset("gddr6-14000", "x"), complete);
  table.reject_unknown();
  return config;
}

// Without `preset`, what a file leaves out stays as it is in the configuration it changes.
TEST(DramConfig, AFileChangesTheConfigurationItStandsIn) {
  const DramConfig config = read("queue_bursts = 3");
  DramConfig expected = dram_preset("gddr6-14000", "x");
  EXPECT_NE(expected.queue_bursts, 3);
  expected.queue_bursts = 3;
  for (const DramKey& key : kDramKeys) EXPECT_EQ(config.*key.value, expected.*key.value) << key.key;
}

TEST(DramConfig, ACompleteFileHasAPresetOrEveryKey) {
  EXPECT_EQ(read("preset = 'hbm2-2000'", true).rp, 14);
  EXPECT_NE(input_error_of([] { read("", true); }).find("'clock_mhz' is missing"),
            std::string::npos);
  for (const DramKey& left_out : kDramKeys) {
    std::string text;
    for (const DramKey& key : kDramKeys) {
      if (key.key == left_out.key) continue;
      text += std::string(key.key) + " = " + std::to_string(DramConfig().*key.value) + '\n';
    }
    const std::string error = input_error_of([&] { read(text, true); });
    EXPECT_NE(error.find("'" + std::string(left_out.key) + "' is missing"), std::string::npos)
        << error;
  }
}

TEST(DramConfig, AFileChangesAPreset) {
  const DramConfig config = read("preset = 'hbm2-2000'\nchannels = 8\n");
  EXPECT_EQ(config.channels, 8);
  EXPECT_EQ(config.rp, 14);
  const auto error_of = [&](const std::string& text) {
    return input_error_of([&] { read(text); });
  };
  EXPECT_EQ(error_of("\npreset = 'ddr5'"),
            "block.toml:2: unknown memory 'ddr5'; expected one of lpddr4-3200, gddr6-14000, "
            "hbm2-2000");
  EXPECT_EQ(error_of("\nrp = 0"), "block.toml:2: 'rp' is 0; expected an integer from 1 to 256");
  EXPECT_EQ(error_of("banks = 12").substr(0, 27), "block.toml:1: 'banks' is 12");
  EXPECT_EQ(error_of("rpp = 12").substr(0, 31), "block.toml:1: unknown key 'rpp'");
}

}  // namespace
}  // namespace wedgesim::model::memory
