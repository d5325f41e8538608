#pragma once

#include <array>
#include <string_view>

namespace wedgesim {
class TomlTable;
}

namespace wedgesim::model::memory {

/// A DRAM: its organization, and its timing in cycles of its command clock. The meaning and the
/// range of each number stand in kDramKeys. The values here are those of `lpddr4-3200`.
struct DramConfig {
  int clock_mhz = 1600;
  int channels = 2, bank_groups = 1, banks = 8;
  int row_bytes = 2048, burst_bytes = 32, interleave_bytes = 64;
  int queue_bursts = 32;

  int burst_cycles = 8, ccd_s = 8, ccd_l = 8;
  int read_latency = 31, write_latency = 15;
  int rcd_read = 29, rcd_write = 29, rp = 29, ras = 68;
  int rrd_s = 16, rrd_l = 16, faw = 64;
  int rtp = 12, wr = 29, wtr_s = 16, wtr_l = 16, turnaround = 3;
  int refi = 6246, rfc = 448;

  /// Bytes a second on the data buses of all channels together.
  double peak_bytes_per_second() const;
};

/// One number of it: file reader, printed configuration, checks and documents share the table.
struct DramKey {
  std::string_view key;
  int DramConfig::*value;
  int low, high;
  bool power_of_two;
  std::string_view what;
};

// clang-format off
inline constexpr std::array kDramKeys{
    DramKey{"clock_mhz", &DramConfig::clock_mhz, 1, 10000, false, "command clock, MHz"},
    DramKey{"channels", &DramConfig::channels, 1, 128, true, "channels, each with buses of its own"},
    DramKey{"bank_groups", &DramConfig::bank_groups, 1, 16, true, "bank groups of a channel"},
    DramKey{"banks", &DramConfig::banks, 1, 64, true, "banks of a channel, over all groups"},
    DramKey{"row_bytes", &DramConfig::row_bytes, 64, 65536, true, "bytes of an open row of a bank"},
    DramKey{"burst_bytes", &DramConfig::burst_bytes, 8, 256, true, "bytes of a burst"},
    DramKey{"interleave_bytes", &DramConfig::interleave_bytes, 8, 65536, true, "bytes before the next channel's turn; at least a burst, at most a row"},
    DramKey{"queue_bursts", &DramConfig::queue_bursts, 1, 1024, false, "bursts of a channel whose banks are prepared ahead"},
    DramKey{"burst_cycles", &DramConfig::burst_cycles, 1, 64, false, "cycles a burst holds the data bus"},
    DramKey{"ccd_s", &DramConfig::ccd_s, 1, 64, false, "column command to column command"},
    DramKey{"ccd_l", &DramConfig::ccd_l, 1, 64, false, "the same in one bank group"},
    DramKey{"read_latency", &DramConfig::read_latency, 1, 256, false, "read command to its first data"},
    DramKey{"write_latency", &DramConfig::write_latency, 1, 256, false, "write command to its first data"},
    DramKey{"rcd_read", &DramConfig::rcd_read, 1, 256, false, "activate to read"},
    DramKey{"rcd_write", &DramConfig::rcd_write, 1, 256, false, "activate to write"},
    DramKey{"rp", &DramConfig::rp, 1, 256, false, "precharge to activate"},
    DramKey{"ras", &DramConfig::ras, 1, 512, false, "activate to precharge; with rp the row cycle"},
    DramKey{"rrd_s", &DramConfig::rrd_s, 1, 256, false, "activate to activate of another bank"},
    DramKey{"rrd_l", &DramConfig::rrd_l, 1, 256, false, "the same in one bank group"},
    DramKey{"faw", &DramConfig::faw, 1, 512, false, "activate to the fourth activate after it"},
    DramKey{"rtp", &DramConfig::rtp, 1, 256, false, "read to precharge"},
    DramKey{"wr", &DramConfig::wr, 1, 256, false, "end of written data to precharge"},
    DramKey{"wtr_s", &DramConfig::wtr_s, 1, 256, false, "end of written data to read"},
    DramKey{"wtr_l", &DramConfig::wtr_l, 1, 256, false, "the same in one bank group"},
    DramKey{"turnaround", &DramConfig::turnaround, 0, 64, false, "idle data bus between read and written data"},
    DramKey{"refi", &DramConfig::refi, 1, 1000000, false, "refresh to refresh of a channel; more than rfc"},
    DramKey{"rfc", &DramConfig::rfc, 1, 10000, false, "refresh to the next command; all banks"},
};
// clang-format on

/// \throws InputError naming the first key out of its range; `place` is where it stands
void check(const DramConfig& config, std::string_view place);

struct DramPreset {
  std::string_view name;
  std::string_view source;
  DramConfig config;
};

/// The memories that a configuration can name.
const std::array<DramPreset, 3>& dram_presets();

/// The preset that the key `preset` names, else `base`, with the keys of kDramKeys that the table
/// sets besides.
/// \param complete  without `preset`, every key is required
/// \throws InputError naming file, line and key if one is missing or out of range; unknown keys are
///         for the caller to reject
DramConfig read_dram(const TomlTable& table, const DramConfig& base, bool complete);

/// \throws InputError listing the names that exist
const DramConfig& dram_preset(std::string_view name, std::string_view place);

}  // namespace wedgesim::model::memory
