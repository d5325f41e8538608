#pragma once

#include <string>
#include <vector>

#include "reports/json.h"
#include "reports/page/chart.h"

namespace wedgesim::reports::page {

/// Parts of Vega-Lite specifications. Colours are CSS variables of the page, so that dark mode and
/// paper need no other specification.

/// The outermost object: data "rows", size, the parameters chosen_s and chosen_x (null, or lists).
Json new_spec(const std::string& description);
/// The channel x of a column: in steps for words and few numbers, else a number line.
Json x_channel(const Column& column, bool log);
/// The channel y.
Json y_channel(const std::string& field, const std::string& title, bool log, bool from_zero);
/// Colours of series, without a legend: the page has buttons for it.
Json colour_channel(const std::vector<std::string>& series);
/// A shape of each series; no two of up to 64 have both shape and colour in common.
Json shape_channel(const std::vector<std::string>& series);
/// Fainter for series that are not chosen.
Json opacity_channel(double full);
/// To median, low and high of y for each x and s.
Json spread_transform();
/// Median, spread and names on a mark.
Json spread_tooltip(const Chart& chart);
/// A layer: a vertical rule at each chosen x.
Json chosen_rule(const Json& x);

/// "z reads (words)"
std::string axis_title(const std::string& label, const std::string& unit);
/// The measure's, or that of all measures if they have one unit.
std::string y_title(const Chart& chart);

}  // namespace wedgesim::reports::page
