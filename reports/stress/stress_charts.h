#pragma once

#include <string>
#include <vector>

#include "reports/page/row_charts.h"
#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// Largest error beyond sensitivity over difficulty, with the bars and the levels that must hold.
page::RowChart excess_chart(const FamilyResult& result);
/// RMS over difficulty, likewise.
page::RowChart rms_chart(const FamilyResult& result);
/// Largest RMS up to the hardest level that the fixed datapath must hold, over the time of a
/// contribution: a mark for each family and arithmetic.
page::RowChart time_chart(const std::vector<FamilyResult>& results);
/// Largest error beyond sensitivity over condition number: a mark for each family, level and
/// arithmetic.
page::RowChart condition_chart(const std::vector<FamilyResult>& results);

/// "1.2e-4", as people write it.
std::string error_text(double error);

}  // namespace wedgesim::reports::stress
