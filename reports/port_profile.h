#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/memory/memory_record.h"

namespace wedgesim::reports {

/// Bytes at the block's memory port, over time and over the frame's tiles. Takes records in any
/// order of their cycles.
class PortProfile {
 public:
  /// Cycles over which the peak is taken.
  static constexpr std::uint64_t kWindowCycles = 1024;

  explicit PortProfile(std::size_t tiles) : tile_bytes_(tiles) {}

  void add(const model::memory::MemoryRecord& record) {
    const std::size_t window = record.cycle / kWindowCycles;
    if (window >= windows_.size()) windows_.resize(window + 1);
    windows_[window] += record.bytes;
    if (record.tile >= 0) tile_bytes_[static_cast<std::size_t>(record.tile)] += record.bytes;
  }

  /// The most bytes of a window, a cycle.
  double peak_bytes_per_cycle() const {
    if (windows_.empty()) return 0.0;
    return static_cast<double>(*std::max_element(windows_.begin(), windows_.end())) /
           static_cast<double>(kWindowCycles);
  }
  /// Of each tile, row by row, what was moved for its visits: not clears, merges and records.
  const std::vector<std::uint64_t>& tile_bytes() const { return tile_bytes_; }

 private:
  std::vector<std::uint64_t> windows_;
  std::vector<std::uint64_t> tile_bytes_;
};

}  // namespace wedgesim::reports
