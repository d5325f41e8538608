#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "model/count/config.h"
#include "traces/trace.h"

namespace wedgesim::model::test {

/// The counters by their definitions, pixel by pixel and tile by tile, with sets of pixels: slow,
/// and sharing with the counter under test only what a contribution is worth and how many bytes a
/// wedge's record has.
struct NaiveCount {
  std::map<std::string, std::uint64_t, std::less<>> counters;
  std::vector<std::int64_t> li;  // (height, width) words of 2^-40
  std::vector<std::uint32_t> z_reads, li_writes;
};

/// \param fail  z-fail
NaiveCount naive_count(const traces::TraceView& trace, const CountConfig& config, bool fail);

}  // namespace wedgesim::model::test
