#pragma once

#include <vector>

#include "reports/accuracy/artifacts.h"
#include "reports/accuracy/measure.h"
#include "reports/accuracy/recommend.h"
#include "reports/json.h"

namespace wedgesim::reports::accuracy {

/// The result of `accuracy`, schema wedgesim.accuracy/1. What hangs on run times, the Pareto front
/// and a recommendation among it, stands under keys "timing".
/// \param wish       null: nothing is recommended
/// \param artifacts  that were shown
Json accuracy_json(const MeasureOptions& options, const std::vector<SceneResult>& scenes,
                   const Wish* wish, std::span<const ShownArtifact> artifacts = {});

}  // namespace wedgesim::reports::accuracy
