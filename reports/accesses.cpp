#include "reports/accesses.h"

namespace wedgesim::reports {

using model::CountResult;

Accesses accesses_of(const CountResult& result) {
  const model::Counters& counters = *result.counters;
  return {counters.z_reads.value(), counters.li_writes.value(), counters.tile_visits.value()};
}

std::uint64_t floor_of(const CountResult& result) {
  return result.counters->z_reads_floor.value() + result.counters->li_writes_floor.value();
}

std::optional<double> over_floor(const CountResult& result) {
  const std::uint64_t floor = floor_of(result);
  if (floor == 0) return std::nullopt;
  return static_cast<double>(accesses_of(result).total()) / static_cast<double>(floor);
}

std::optional<double> saved_percent(std::uint64_t from, std::uint64_t to) {
  if (from == 0) return std::nullopt;
  return 100.0 * (1.0 - static_cast<double>(to) / static_cast<double>(from));
}

}  // namespace wedgesim::reports
