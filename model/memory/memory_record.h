#pragma once

#include <cstdint>
#include <string_view>

#include "model/memory/cycle.h"
#include "model/memory/layout.h"

namespace wedgesim::model::memory {

/// Why an access goes to memory.
enum class Cause : std::uint8_t {
  fetch,
  fill,
  write_back,
  write_through,
  flush,
  clear,
  build,
  merge
};
std::string_view name_of(Cause cause);

/// One access as the block sends it to its memory.
struct MemoryRecord {
  static constexpr std::int64_t kNone = -1;

  Cycle cycle = 0;
  Surface client = Surface::z;  // whose bytes these are
  bool write = false;
  std::uint64_t address = 0;
  std::uint32_t bytes = 0;
  std::int64_t tile = kNone;   // index row by row, or none
  std::int64_t wedge = kNone;  // index in the trace, or none
  Cause cause = Cause::fill;
};

}  // namespace wedgesim::model::memory
