#pragma once

#include <string>

#include "reports/runner/runner.h"

namespace wedgesim::reports {

/// What a run would do: every point, with the seconds that it took or may take, and all together.
/// Expected seconds are the mean of those that points of the same measure took before, on the same
/// frame or, by its pixels, on others; without any, a guess. Writes nothing.
std::string dry_run(const Study& study, const RunOptions& options);

}  // namespace wedgesim::reports
