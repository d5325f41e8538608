#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "reports/json.h"

namespace wedgesim::reports::page {

/// A chart that has its own rows {x, s, y, …}, s the series, and their Vega-Lite specification.
/// All such charts of a page have the same series, and one legend.
struct RowChart {
  std::string id, title;
  std::string caption;  // what it says, in words computed from the data
  Json spec;
  Json rows;
};

/// The channels of a mark: its place, and colour and faintness by its series.
Json mark_channels(const std::vector<std::string>& series, Json x, Json y);

/// A field of rows in a tooltip, as it is written there.
Json tooltip_field(const std::string& field, const std::string& title);

/// The chart's figure, without its marks: script/row_charts.js draws them.
/// \param heading  "h3"
std::string chart_html(const RowChart& chart, std::string_view heading);

/// The section with the legend's buttons, which the script makes.
/// \param name  of what the series are: "Arithmetics"
std::string legend_html(std::string_view name);

/// What the script needs.
/// \param series  in the order of their colours
Json row_chart_data(const std::vector<std::string>& series, const std::vector<RowChart>& charts);

}  // namespace wedgesim::reports::page
