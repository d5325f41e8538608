#pragma once

#include <vector>

#include "reports/page/chart.h"

namespace wedgesim::reports::page {

/// Of studies in time: what each unit does with its cycles, and how busy the units are in each
/// configuration of the study's first axis.
std::vector<Chart> unit_charts(const Columns& columns);

}  // namespace wedgesim::reports::page
