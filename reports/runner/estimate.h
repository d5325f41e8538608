#pragma once

#include <string>

#include "reports/runner/runner.h"

namespace wedgesim::reports {

/// What a run would do: every point, with the seconds that it took or may take, and all together.
/// Expected seconds are those a pixel that points of the same measure took before, on the same
/// frame or else on all; without any, a guess. Writes nothing.
std::string dry_run(const Study& study, const RunOptions& options);

}  // namespace wedgesim::reports
