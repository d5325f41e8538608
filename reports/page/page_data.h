#pragma once

#include "reports/json.h"
#include "reports/page/chart.h"
#include "reports/page/page.h"

namespace wedgesim::reports::page {

/// Of more points than this the page holds only metrics that its table or a chart shows: the files
/// beside it hold all.
inline constexpr std::size_t kMostWholePoints = 2500;

/// What the page's script works with: columns (a value that all points share is stored once, words
/// by their place in a list), axes, charts and heat maps.
Json page_data(const Page& page, const Columns& columns, const std::vector<Chart>& charts);

}  // namespace wedgesim::reports::page
