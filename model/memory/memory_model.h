#pragma once

#include <cstdint>

#include "base/counter.h"
#include "model/memory/cycle.h"

namespace wedgesim::model::memory {

/// A memory behind the block: says when each access is done, in cycles of the block's clock.
class MemoryModel {
 public:
  virtual ~MemoryModel() = default;

  /// \param address  of the first byte
  /// \param bytes    at least 1
  /// \param at       the cycle in which the access arrives; never less than in the call before
  /// \return the cycle from which a read's bytes are there, or a write's have been taken
  virtual Cycle access(std::uint64_t address, unsigned bytes, bool write, Cycle at) = 0;

  /// The most that can be moved, bytes in one cycle of the block's clock.
  virtual double peak_bytes_per_cycle() const = 0;
  virtual const Group& statistics() const = 0;
};

}  // namespace wedgesim::model::memory
