#pragma once

#include <string>

#include "reports/page/chart.h"
#include "reports/page/page.h"

namespace wedgesim::reports::page {

// Parts of the page as HTML.

/// What was studied, the best configuration, the findings, what failed.
std::string summary_html(const Columns& columns);
/// A figure a chart, empty until the script draws it, with its caption.
std::string charts_html(const std::vector<Chart>& charts);
/// A section each, with heading, text and table.
std::string sections_html(const std::vector<Section>& sections);
/// A list of links.
std::string downloads_html(const std::vector<Link>& links);

}  // namespace wedgesim::reports::page
