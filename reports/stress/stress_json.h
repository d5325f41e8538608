#pragma once

#include <vector>

#include "reports/json.h"
#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// The result of `stress`, schema wedgesim.stress/1. Nothing in it varies between identical runs
/// but "timing".
Json stress_json(const RunOptions& options, const std::vector<FamilyResult>& results);

}  // namespace wedgesim::reports::stress
