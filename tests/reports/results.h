#pragma once

#include <cstdint>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/count/count.h"

namespace wedgesim::reports {

/// A result as count() would give it, with these accesses and nothing wrong.
inline model::CountResult make_result(const model::CountConfig& config, std::uint64_t reads,
                                      std::uint64_t writes, std::uint64_t visits = 0) {
  model::CountResult result;
  result.config = config;
  result.counters = std::make_unique<model::Counters>();
  result.counters->z_reads = reads;
  result.counters->li_writes = writes;
  result.counters->tile_visits = visits;
  result.counters->z_reads_floor = 100;
  result.counters->li_writes_floor = 50;
  result.counters->all_bytes = 2500 * reads;
  result.pixels.compared = 6;
  result.pixels.tolerance = 1e-6;
  result.seconds = 0.25;
  return result;
}

}  // namespace wedgesim::reports
