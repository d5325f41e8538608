#pragma once

#include <string>
#include <vector>

#include "reports/json.h"
#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// A chart of the page: rows {x, s, y, …}, s the arithmetic, and their Vega-Lite specification.
struct StressChart {
  std::string id, title;
  std::string caption;  // what it says, in words computed from the data
  Json spec;
  Json rows;
};

/// Largest error beyond sensitivity over difficulty, with the bars and the levels that must hold.
StressChart excess_chart(const FamilyResult& result);
/// RMS over difficulty, likewise.
StressChart rms_chart(const FamilyResult& result);
/// Largest RMS up to the hardest level that the fixed datapath must hold, over the time of a
/// contribution: a mark for each family and arithmetic.
StressChart time_chart(const std::vector<FamilyResult>& results);
/// Largest error beyond sensitivity over condition number: a mark for each family, level and
/// arithmetic.
StressChart condition_chart(const std::vector<FamilyResult>& results);

/// "1.2e-4", as people write it.
std::string error_text(double error);

}  // namespace wedgesim::reports::stress
