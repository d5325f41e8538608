#include "model/memory/ideal_memory.h"

#include <algorithm>

#include "base/check.h"
#include "model/memory/config_check.h"

namespace wedgesim::model::memory {

IdealMemory::IdealMemory(const IdealMemoryConfig& config, std::string_view place)
    : latency_(static_cast<std::uint64_t>(config.latency_cycles)),
      bytes_per_cycle_(static_cast<std::uint64_t>(config.bytes_per_cycle)) {
  check_range(place, "latency_cycles", config.latency_cycles, 0, 1'000'000);
  check_range(place, "bytes_per_cycle", config.bytes_per_cycle, 1, 65'536);
}

Cycle IdealMemory::access(std::uint64_t /*address*/, unsigned bytes, bool write, Cycle at) {
  CHECK_GE(bytes, 1U);
  CHECK_LE(last_at_, at);
  last_at_ = at;
  (write ? writes_ : reads_) += 1;
  (write ? write_bytes_ : read_bytes_) += bytes;
  free_byte_ = std::max(free_byte_, at * bytes_per_cycle_) + bytes;
  return (free_byte_ + bytes_per_cycle_ - 1) / bytes_per_cycle_ + latency_;
}

}  // namespace wedgesim::model::memory
