#pragma once

#include <cstdint>
#include <optional>

#include "model/count/count.h"

namespace wedgesim::reports {

/// Paper II's measure of a run: words of depth read and of LI written.
struct Accesses {
  std::uint64_t reads = 0, writes = 0, visits = 0;
  std::uint64_t total() const { return reads + writes; }
};
Accesses accesses_of(const model::CountResult& result);

/// The words that any design must read and write for this frame, and how often over them a run
/// goes; nothing if there are none.
std::uint64_t floor_of(const model::CountResult& result);
std::optional<double> over_floor(const model::CountResult& result);

/// The part that `to` saves of `from`, in per cent; nothing if there is none to save.
std::optional<double> saved_percent(std::uint64_t from, std::uint64_t to);

}  // namespace wedgesim::reports
