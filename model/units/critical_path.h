#pragma once

#include <array>
#include <cstddef>
#include <numeric>

#include "model/memory/cycle.h"

namespace wedgesim::model::units {

/// Which part of the block each cycle up to a moment waited for: of whatever two things a unit
/// needs to go on, the one that came last passes its own account on. Adds up to the moment's cycle,
/// so a part that is a little faster saves its share, as long as nothing else comes last instead.
class CriticalPath {
 public:
  /// Of a unit: its own work, its memory, and the way through the queue behind it.
  enum class Part { work, memory, queue };
  static constexpr std::size_t kParts = 3;
  static constexpr std::size_t kUnits = 7;  // in the order of the pipeline

  void add(std::size_t unit, Part part, memory::Cycle cycles) {
    cycles_[kParts * unit + static_cast<std::size_t>(part)] += cycles;
  }
  memory::Cycle of(std::size_t unit, Part part) const {
    return cycles_[kParts * unit + static_cast<std::size_t>(part)];
  }
  memory::Cycle total() const {
    return std::accumulate(cycles_.begin(), cycles_.end(), memory::Cycle{0});
  }

 private:
  std::array<memory::Cycle, kParts * kUnits> cycles_{};
};

}  // namespace wedgesim::model::units
