#pragma once

#include <algorithm>
#include <string_view>
#include <vector>

#include "model/memory/cache.h"
#include "model/units/memory_port.h"

namespace wedgesim::model::units {

/// How many accesses of a unit may be under way. The oldest must be back before one more leaves.
class Outstanding {
 public:
  explicit Outstanding(int most) : done_(static_cast<std::size_t>(most)) {}

  /// Waits, stalled, until another may leave.
  void wait_for_one(UnitTime& time) const { time.wait_for_memory_until(done_[next_]); }
  /// Waits, stalled, until all are back.
  void wait_for_all(UnitTime& time) const { time.wait_for_memory_until(last_); }
  void add(Cycle done) {
    last_ = std::max(last_, done);
    done_[next_] = done;
    next_ = (next_ + 1) % done_.size();
  }

 private:
  std::vector<Cycle> done_;
  std::size_t next_ = 0;
  Cycle last_ = 0;
};

/// Reads lines through a cache; misses overlap.
class LineReader {
 public:
  LineReader(MemoryPort& port, const memory::CacheConfig& cache, int outstanding,
             std::string_view place)
      : port_(port), cache_(cache, place), outstanding_(outstanding) {}

  /// \return the cycle from which the line's bytes are there
  Cycle read(UnitTime& time, const AccessTag& tag, std::uint64_t line) {
    const memory::Cache::Access access = cache_.access(line, false);
    if (access.hit) return cache_.ready(access.slot);
    outstanding_.wait_for_one(time);
    const Cycle done = port_.access(time, tag, line, memory::kLineBytes, false);
    outstanding_.add(done);
    if (access.slot != memory::Cache::kNoSlot) cache_.set_ready(access.slot, done);
    return done;
  }

  const memory::Cache& cache() const { return cache_; }

 private:
  MemoryPort& port_;
  memory::Cache cache_;
  Outstanding outstanding_;
};

}  // namespace wedgesim::model::units
