#include "model/memory/energy.h"

#include <gtest/gtest.h>

#include "tests/support/expect_input_error.h"

namespace wedgesim::model::memory {
namespace {

constexpr std::string_view kText =
    "datapath_word_pj = 0.5\ncache_access_pj = 10\ndram_byte_pj = 40\ndram_activate_pj = 2000\n";

EnergyTable table_of(const std::string& text) {
  const toml::table root = parse_toml(text, "energy.toml");
  return read_energy(TomlTable(root, "energy.toml"));
}

TEST(Energy, IsCountsTimesTheUsersTable) {
  const Energy energy = energy_of(table_of(std::string(kText)), {1000, 100, 64, 2});
  EXPECT_EQ(energy.datapath, 500.0);
  EXPECT_EQ(energy.cache, 1000.0);
  EXPECT_EQ(energy.dram_bytes, 2560.0);
  EXPECT_EQ(energy.dram_activates, 4000.0);
  EXPECT_EQ(energy.total(), 8060.0);
}

TEST(Energy, KeysAreChecked) {
  const auto error = [](const std::string& text) {
    return input_error_of([&] { table_of(text); });
  };
  EXPECT_EQ(error("datapath_word_pj = 1"),
            "energy.toml:1: 'cache_access_pj' is missing; expected a number");
  EXPECT_EQ(error("datapath_word_pj = -1"),
            "energy.toml:1: 'datapath_word_pj' is -1; expected a number from 0 to 1e+12");
  EXPECT_EQ(error(std::string(kText) + "sram_pj = 1\n"),
            "energy.toml:5: unknown key 'sram_pj'; expected one of datapath_word_pj, "
            "cache_access_pj, dram_byte_pj, dram_activate_pj");
}

}  // namespace
}  // namespace wedgesim::model::memory
