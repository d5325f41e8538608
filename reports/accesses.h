#pragma once

#include <cstdint>
#include <optional>
#include <set>

#include "reports/study.h"

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

/// The result of a configuration on a scene; null if the study does not hold it.
const model::CountResult* find(const SceneResults& scene, const model::CountConfig& config);

/// All tile edges of a study.
std::set<unsigned> tiles_of(const Study& study);

/// The part that `to` saves of `from`, in per cent; nothing if there is none to save.
std::optional<double> saved_percent(std::uint64_t from, std::uint64_t to);

/// The tile edge with the fewest accesses if a tile visit costs some too; 0 if there is none.
/// \param config      of every tile size
/// \param visit_cost  accesses a tile visit
unsigned best_tile(const StudyResults& results, const SceneResults& scene,
                   model::CountConfig config, std::uint64_t visit_cost);

}  // namespace wedgesim::reports
