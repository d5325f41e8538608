#include "model/memory/dram_config.h"

#include <fmt/format.h>

#include <optional>
#include <vector>

#include "base/error.h"
#include "base/toml_table.h"
#include "model/memory/config_check.h"

namespace wedgesim::model::memory {

double DramConfig::peak_bytes_per_second() const {
  return static_cast<double>(channels) * burst_bytes / burst_cycles * clock_mhz * 1e6;
}

void check(const DramConfig& config, std::string_view place) {
  for (const DramKey& key : kDramKeys) {
    const auto check_value = key.power_of_two
                                 ? check_power_of_two
                                 : static_cast<decltype(&check_power_of_two)>(check_range);
    check_value(place, key.key, config.*key.value, key.low, key.high);
  }
  check_range(place, "bank_groups", config.bank_groups, 1, config.banks);
  check_range(place, "burst_bytes", config.burst_bytes, 8, config.row_bytes);
  check_range(place, "interleave_bytes", config.interleave_bytes, config.burst_bytes,
              config.row_bytes);
  check_range(place, "refi", config.refi, config.rfc + 1, 1000000);
}

const std::array<DramPreset, 3>& dram_presets() {
  static const std::array<DramPreset, 3> kPresets{
      DramPreset{"lpddr4-3200", "JESD209-4, 8 Gb x16 a channel; DRAMSys JEDEC_512Mbx16_LPDDR4-3200",
                 DramConfig{}},
      DramPreset{"gddr6-14000",
                 "JESD250; rows, banks, burst, tCCD: Micron MT61K256M32, 14 Gb/s; core timing: "
                 "Ramulator 2 GDDR6_2000_1350mV",
                 {.clock_mhz = 1750,
                  .channels = 2,
                  .bank_groups = 4,
                  .banks = 16,
                  .row_bytes = 2048,
                  .burst_bytes = 32,
                  .interleave_bytes = 32,
                  .burst_cycles = 2,
                  .ccd_s = 2,
                  .ccd_l = 3,
                  .read_latency = 24,
                  .write_latency = 6,
                  .rcd_read = 26,
                  .rcd_write = 16,
                  .rp = 26,
                  .ras = 53,
                  .rrd_s = 7,
                  .rrd_l = 7,
                  .faw = 28,
                  .rtp = 4,
                  .wr = 26,
                  .wtr_s = 9,
                  .wtr_l = 11,
                  .turnaround = 4,
                  .refi = 3333,
                  .rfc = 210}},
      DramPreset{"hbm2-2000",
                 "JESD235, pseudo-channel mode, one stack; DRAMSys HBM2",
                 {.clock_mhz = 1000,
                  .channels = 16,
                  .bank_groups = 4,
                  .banks = 16,
                  .row_bytes = 1024,
                  .burst_bytes = 32,
                  .interleave_bytes = 32,
                  .burst_cycles = 2,
                  .ccd_s = 2,
                  .ccd_l = 3,
                  .read_latency = 18,
                  .write_latency = 7,
                  .rcd_read = 12,
                  .rcd_write = 6,
                  .rp = 14,
                  .ras = 28,
                  .rrd_s = 4,
                  .rrd_l = 6,
                  .faw = 16,
                  .rtp = 5,
                  .wr = 14,
                  .wtr_s = 4,
                  .wtr_l = 9,
                  .turnaround = 5,
                  .refi = 3900,
                  .rfc = 220}},
  };
  return kPresets;
}

DramConfig read_dram(const TomlTable& table, const DramConfig& base, bool complete) {
  DramConfig config = base;
  const bool preset = table.has("preset");
  if (preset) config = dram_preset(table.text("preset"), table.place("preset"));
  for (const DramKey& key : kDramKeys) {
    int& value = config.*key.value;
    const auto fallback = complete && !preset ? std::optional<int>() : std::optional<int>(value);
    value = table.integer(key.key, fallback, key.low, key.high);
  }
  check(config, table.place());
  return config;
}

const DramConfig& dram_preset(std::string_view name, std::string_view place) {
  std::vector<std::string_view> names;
  for (const DramPreset& preset : dram_presets()) {
    if (preset.name == name) return preset.config;
    names.push_back(preset.name);
  }
  throw InputError(place, fmt::format("unknown memory '{}'", name),
                   fmt::format("one of {}", fmt::join(names, ", ")));
}

}  // namespace wedgesim::model::memory
