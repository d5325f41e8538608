#include "model/memory/dram.h"

#include <algorithm>

#include "base/check.h"
#include "model/memory/config_check.h"

namespace wedgesim::model::memory {
namespace {

/// The first cycle of one clock that is not before a cycle of the other: exact, without a unit of
/// time that neither clock's period is a multiple of.
std::uint64_t convert(std::uint64_t cycle, std::uint64_t to_mhz, std::uint64_t from_mhz) {
  return (cycle * to_mhz + from_mhz - 1) / from_mhz;
}

/// Takes the lowest digit of `address` in a base that is a power of two.
unsigned take(std::uint64_t& address, int base) {
  const auto digits = static_cast<std::uint64_t>(base);
  const std::uint64_t digit = address % digits;
  address /= digits;
  return static_cast<unsigned>(digit);
}

const DramConfig& checked(const DramConfig& config, std::string_view place) {
  check(config, place);
  return config;
}

}  // namespace

Dram::Dram(const DramConfig& config, int block_mhz, std::string_view place)
    : config_(checked(config, place)),
      memory_mhz_(static_cast<std::uint64_t>(config.clock_mhz)),
      block_mhz_(static_cast<std::uint64_t>(block_mhz)) {
  check_range(place, "block_mhz", block_mhz, 1, 10000);
  for (int channel = 0; channel < config.channels; ++channel) {
    channels_.emplace_back(config, static_cast<unsigned>(channel), statistics_, listener_);
  }
}

Dram::Place Dram::place_of(std::uint64_t address) const {
  take(address, config_.interleave_bytes);
  const unsigned channel = take(address, config_.channels);
  const unsigned group = take(address, config_.bank_groups);
  take(address, config_.row_bytes / config_.interleave_bytes);  // the column's upper part
  const unsigned bank = take(address, config_.banks / config_.bank_groups);
  return {channel, bank * static_cast<unsigned>(config_.bank_groups) + group, address};
}

Cycle Dram::access(std::uint64_t address, unsigned bytes, bool write, Cycle at) {
  CHECK_GE(bytes, 1U);
  CHECK_LE(last_at_, at);
  CHECK_LT(at, Cycle{1} << 48);
  last_at_ = at;
  (write ? statistics_.writes : statistics_.reads) += 1;
  const auto burst_bytes = static_cast<std::uint64_t>(config_.burst_bytes);
  const auto arrival = static_cast<DramCycle>(convert(at, memory_mhz_, block_mhz_));
  DramCycle done = 0;
  for (std::uint64_t burst = address / burst_bytes; burst <= (address + bytes - 1) / burst_bytes;
       ++burst) {
    const Place place = place_of(burst * burst_bytes);
    done = std::max(done, channels_[place.channel].burst(place.bank, place.row, write, arrival));
    (write ? statistics_.write_bursts : statistics_.read_bursts) += 1;
    statistics_.bytes += burst_bytes;
  }
  return convert(static_cast<std::uint64_t>(done), block_mhz_, memory_mhz_);
}

double Dram::peak_bytes_per_cycle() const {
  return config_.peak_bytes_per_second() / (static_cast<double>(block_mhz_) * 1e6);
}

}  // namespace wedgesim::model::memory
