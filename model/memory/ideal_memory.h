#pragma once

#include <string_view>

#include "model/memory/memory_model.h"

namespace wedgesim::model::memory {

struct IdealMemoryConfig {
  int latency_cycles = 100;  // 0 to 1,000,000
  int bytes_per_cycle = 64;  // 1 to 65,536
};

/// A pipe: accesses pass in order, at most bytes_per_cycle each cycle, and each takes
/// latency_cycles from its last byte's passing. Its latency hides: accesses overlap.
class IdealMemory final : public MemoryModel {
 public:
  /// \throws InputError naming the key and its range; `place` is where the configuration stands
  explicit IdealMemory(const IdealMemoryConfig& config, std::string_view place = "memory");

  Cycle access(std::uint64_t address, unsigned bytes, bool write, Cycle at) override;
  double peak_bytes_per_cycle() const override { return static_cast<double>(bytes_per_cycle_); }
  const Group& statistics() const override { return statistics_; }

 private:
  std::uint64_t latency_;
  std::uint64_t bytes_per_cycle_;
  std::uint64_t free_byte_ = 0;  // of the pipe: bytes_per_cycle_ of them each cycle
  Cycle last_at_ = 0;
  Group statistics_;
  Counter reads_{statistics_, "reads", Unit::accesses, "Read accesses"};
  Counter writes_{statistics_, "writes", Unit::accesses, "Write accesses"};
  Counter read_bytes_{statistics_, "read_bytes", Unit::bytes, "Bytes read"};
  Counter write_bytes_{statistics_, "write_bytes", Unit::bytes, "Bytes written"};
};

}  // namespace wedgesim::model::memory
