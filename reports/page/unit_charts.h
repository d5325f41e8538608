#pragma once

#include <vector>

#include "reports/page/chart.h"

namespace wedgesim::reports::page {

/// Of studies in time: what each unit does with its cycles, and what the frame's end waited for at
/// each value of the study's first axes.
std::vector<Chart> unit_charts(const Columns& columns);

}  // namespace wedgesim::reports::page
