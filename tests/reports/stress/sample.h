#pragma once

#include <vector>

#include "reports/stress/run.h"

namespace wedgesim::reports::stress::tests {

/// Made-up results of two families of 4 levels and 2 seeds, 4x3 pixels, judge LI 0.5. `steady`
/// holds throughout. `brittle` must hold to 1e-4 in fixed and double; float32 is off by 0.25 at
/// pixel 5 from 1e-3 on, seed 1; double by 0.001 at pixels 0 and 1 at 1e-4, seed 0, with wedge 7
/// flagged and pixel 1 at no flagged or foreseen wedge; at 0 both seeds are refused. Words hold
/// HTML.
std::vector<FamilyResult> sample_results();

/// Without pictures, as of a case that holds.
Measurement sample_measurement();

}  // namespace wedgesim::reports::stress::tests
