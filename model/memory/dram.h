#pragma once

#include <string_view>
#include <vector>

#include "model/memory/dram_channel.h"
#include "model/memory/memory_model.h"

namespace wedgesim::model::memory {

/// A DRAM with open rows behind a controller that serves each channel in order (no reordering of
/// row hits before others). docs/memory.md says what is modelled and what is left out.
///
/// An address, from its highest bit to its lowest: row, bank, column, bank group, channel, byte
/// within interleave_bytes. There is no end of rows: the capacity is the user's concern.
class Dram final : public MemoryModel {
 public:
  /// \param block_mhz  the block's clock, in whose cycles access() speaks; 1 to 10000
  /// \throws InputError naming the key and its range; `place` is where the configuration stands
  Dram(const DramConfig& config, int block_mhz, std::string_view place = "memory");
  Dram(const Dram&) = delete;
  Dram& operator=(const Dram&) = delete;

  Cycle access(std::uint64_t address, unsigned bytes, bool write, Cycle at) override;
  double peak_bytes_per_cycle() const override;
  const Group& statistics() const override { return statistics_.group; }
  const DramStatistics& counters() const { return statistics_; }

  /// Calls `listener` for every command from now on: burst by burst, not by cycle.
  void listen(DramListener listener) { listener_ = std::move(listener); }

  struct Place {
    unsigned channel = 0, bank = 0;  // the bank's group is bank modulo bank_groups
    std::uint64_t row = 0;
  };
  Place place_of(std::uint64_t address) const;

 private:
  const DramConfig config_;
  const std::uint64_t memory_mhz_, block_mhz_;
  DramStatistics statistics_;
  DramListener listener_;
  std::vector<DramChannel> channels_;
  Cycle last_at_ = 0;
};

}  // namespace wedgesim::model::memory
