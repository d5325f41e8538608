#include "reports/accesses.h"

#include <limits>

namespace wedgesim::reports {

using model::CountConfig;
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

const CountResult* find(const SceneResults& scene, const CountConfig& config) {
  for (const CountResult& result : scene.results) {
    if (result.config == config) return &result;
  }
  return nullptr;
}

std::set<unsigned> tiles_of(const Study& study) {
  std::set<unsigned> tiles;
  for (const CountConfig& config : study.configs) tiles.insert(config.tile);
  return tiles;
}

std::optional<double> saved_percent(std::uint64_t from, std::uint64_t to) {
  if (from == 0) return std::nullopt;
  return 100.0 * (1.0 - static_cast<double>(to) / static_cast<double>(from));
}

unsigned best_tile(const StudyResults& results, const SceneResults& scene, CountConfig config,
                   std::uint64_t visit_cost) {
  unsigned best = 0;
  std::uint64_t least = std::numeric_limits<std::uint64_t>::max();
  for (const unsigned tile : tiles_of(results.study)) {
    config.tile = tile;
    const CountResult* result = find(scene, config);
    if (result == nullptr) continue;
    const Accesses accesses = accesses_of(*result);
    const std::uint64_t cost = accesses.total() + visit_cost * accesses.visits;
    if (cost < least) {
      least = cost;
      best = tile;
    }
  }
  return best;
}

}  // namespace wedgesim::reports
