#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "reports/json.h"
#include "reports/page/columns.h"
#include "reports/page/statistics.h"

namespace wedgesim::reports::page {

/// A column that a chart draws, and what it is called there.
struct Measure {
  const Column* column = nullptr;
  std::string name;
  std::string at = {};  // its x, in a chart without a column of x
};

/// Settings that a chart keeps fixed while it shows others, unless the reader chooses otherwise.
using Held = std::vector<std::pair<const Column*, Value>>;

/// A chart: which points it draws, and its Vega-Lite specification over rows {x, s, m, y, scene,
/// frame}: x and series, the measure's name and value. The page's script makes the rows.
struct Chart {
  std::string id;
  std::string title;
  std::string about;               // what it shows, one sentence
  std::string caption;             // what it says, in words computed from the data
  const Column* x = nullptr;       // null: x is the measure's `at`
  const Column* series = nullptr;  // null: the measures' names tell series apart
  std::vector<Measure> measures;
  const Column* per = nullptr;  // y is divided by it, if not null
  Held held;
  Json spec;
};

/// One point in one measure, as the script makes it.
struct Row {
  Value x;
  std::string series;
  double y = 0.0;
};
std::vector<Row> rows_of(const Columns& columns, const Chart& chart);

/// The names of a chart's series, in the order of their colours; {""} if it has none.
std::vector<std::string> series_of(const Chart& chart);

/// Chooses what to hold: of all axes that the chart does not draw, the combination of values under
/// which it has the most x and series; among those the one with the most usual values, then the one
/// with the most values of the best configuration (findings.h), then the largest frames. Over a
/// parameter of frames also those frames that differ in it alone.
Held choose_held(const Columns& columns, const Chart& chart);

/// The spread of y for each series and x, x in the order of their column.
struct Line {
  std::string series;
  std::vector<std::pair<Value, Spread>> at;
};
std::vector<Line> lines_of(const Columns& columns, const Chart& chart);

/// Fills series, `held`, specification and caption of a chart; nothing if it would show fewer than
/// two values.
std::optional<Chart> finish_lines(const Columns& columns, Chart chart);  // median and band over x
std::optional<Chart> finish_bars(const Columns& columns, Chart chart);   // median and range of each
std::optional<Chart> finish_dots(const Columns& columns, Chart chart, bool log);  // every point

/// Cost over "pixels" or "wedges", not finished; nothing if the study varies them too little.
std::optional<Chart> scaling_chart(const Columns& columns, std::string_view key);

/// What all specifications have in common, as Vega-Lite's "config".
Json chart_config();

/// Every chart that a study has data for, in the page's order.
std::vector<Chart> make_charts(const Columns& columns);

}  // namespace wedgesim::reports::page
