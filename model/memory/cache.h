#pragma once

#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include "base/counter.h"
#include "model/memory/cycle.h"

namespace wedgesim::model::memory {

struct CacheConfig {
  int size_bytes = 4096;  // a power of two up to 2^26; 0 = no cache
  int line_bytes = 64;    // a power of two from 8 to 4096
  int ways = 4;           // a power of two up to 64, at most the lines there are
};

/// Set-associative, least recently used out first, write-back, write-allocate. Knows which lines
/// it holds, not their bytes. A cache of size 0 holds nothing: each access misses, and a write
/// goes through at once.
class Cache {
 public:
  struct Access {
    bool hit = false;
    bool fill = false;                        // the line must be fetched
    std::optional<std::uint64_t> write_back;  // address of a line whose bytes must go to memory
    std::size_t slot = kNoSlot;               // where the line is now, until its next eviction
    Cycle write_back_ready = 0;               // when the bytes of write_back were there,
    Cycle write_back_settled = 0;             // and when the last of them was written
  };
  static constexpr std::size_t kNoSlot = ~std::size_t{0};

  /// \throws InputError naming the key and its range; `place` is where the configuration stands
  explicit Cache(const CacheConfig& config, std::string_view place = "cache");

  /// One access of a line. A line that comes in is ready from cycle 0 until set_ready says else.
  /// \param line_address  a multiple of line_bytes
  Access access(std::uint64_t line_address, bool write) {
    const std::uint64_t line = line_address >> line_shift_;
    Line* const set = lines_.data() + (line & set_mask_) * ways_;
    ++time_;
    for (std::size_t way = 0; way < ways_; ++way) {
      if (set[way].line == line) {
        set[way].used = time_;
        set[way].dirty |= write;
        hits_ += 1;
        return {true, false, {}, static_cast<std::size_t>(set + way - lines_.data())};
      }
    }
    return miss(set, line, write);
  }

  /// The cycle from which a line's bytes are there: the user sets it when it knows when the
  /// fill returns.
  Cycle ready(std::size_t slot) const { return lines_[slot].ready; }
  void set_ready(std::size_t slot, Cycle cycle) { lines_[slot].ready = cycle; }

  /// The cycle in which its last write is done: its bytes may not leave before. The user sets it.
  void set_settled(std::size_t slot, Cycle cycle) { lines_[slot].settled = cycle; }

  /// Calls `visit(line address, slot)` for each dirty line, sets and ways in order; all are clean
  /// then.
  template <typename Visit>
  void flush(Visit visit) {
    for (std::size_t slot = 0; slot < lines_.size(); ++slot) {
      Line& line = lines_[slot];
      if (!line.dirty) continue;
      line.dirty = false;
      write_backs_ += 1;
      visit(line.line << line_shift_, slot);
    }
  }

  std::uint64_t size_bytes() const { return std::uint64_t{lines_.size()} << line_shift_; }
  Group& statistics() { return statistics_; }
  const Group& statistics() const { return statistics_; }
  std::uint64_t hits() const { return hits_.value(); }
  std::uint64_t misses() const { return misses_.value(); }
  std::uint64_t evictions() const { return evictions_.value(); }
  std::uint64_t write_backs() const { return write_backs_.value(); }

 private:
  static constexpr std::uint64_t kEmpty = ~std::uint64_t{0};  // no line: addresses have 64 bits
  struct Line {
    std::uint64_t line = kEmpty;  // address / line_bytes
    std::uint64_t used = 0;       // time of the last access; 0 = never
    Cycle ready = 0, settled = 0;
    bool dirty = false;
  };
  Access miss(Line* set, std::uint64_t line, bool write);

  unsigned line_shift_ = 0;
  std::size_t ways_ = 0;
  std::uint64_t set_mask_ = 0;
  std::uint64_t time_ = 0;
  std::vector<Line> lines_;  // (sets, ways)
  Group statistics_;
  Counter hits_{statistics_, "hits", Unit::accesses, "Accesses of lines that the cache held"};
  Counter misses_{statistics_, "misses", Unit::accesses, "Accesses of lines that it did not hold"};
  Counter evictions_{statistics_, "evictions", Unit::accesses, "Lines put out for another"};
  Counter write_backs_{statistics_, "write_backs", Unit::accesses,
                       "Dirty lines put out, flushed or written through"};
};

}  // namespace wedgesim::model::memory
