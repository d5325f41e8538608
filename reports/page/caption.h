#pragma once

#include <string>

#include "reports/page/chart.h"

namespace wedgesim::reports::page {

/// What lines say: how many frames, the best and the worst, how each line runs from its first x to
/// its last.
std::string line_caption(const Columns& columns, const Chart& chart);
/// What bars say: the best and the worst.
std::string bar_caption(const Columns& columns, const Chart& chart);
/// What dots say: how many, from where to where, the fitted slope if the chart is log-log.
std::string dot_caption(const Columns& columns, const Chart& chart, bool log);

/// The unit that all measures of a chart have; else empty.
std::string y_unit(const Chart& chart);
/// "3.1-fold", "12 % less": of a ratio.
std::string change_text(double ratio);
/// "a, b and c"
std::string listed(const std::vector<std::string>& words);

}  // namespace wedgesim::reports::page
