#include "reports/page/unit_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <map>

#include "model/block/block.h"
#include "reports/page/caption.h"
#include "reports/page/chart_spec.h"
#include "reports/page/names.h"

namespace wedgesim::reports::page {
namespace {

constexpr std::array<const char*, 3> kStates{"busy", "stalled", "starved"};
constexpr std::size_t kRowHeight = 28;  // pixels
constexpr int kSlantedLabel = 64;       // pixels that the last one reaches beyond its column
constexpr const char* kSuffix = ".busy_cycles";

// Along the pipeline; units that it does not name last.
std::vector<std::string> units_of(const Columns& columns) {
  std::vector<std::string> units;
  for (const Column& column : columns.all()) {
    if (column.key.ends_with(kSuffix) && column.is_number()) {
      units.push_back(column.key.substr(0, column.key.size() - std::string(kSuffix).size()));
    }
  }
  std::ranges::stable_sort(units, {}, [](const std::string& unit) {
    return std::ranges::find(model::kBlockUnits, unit) - model::kBlockUnits.begin();
  });
  return units;
}

using Means = std::map<std::string, std::map<std::string, double>>;  // by series, then x

Means means_of(const Columns& columns, const Chart& chart) {
  std::map<std::string, std::map<std::string, std::vector<double>>> values;
  for (const Row& row : rows_of(columns, chart)) {
    values[row.series][value_text(row.x)].push_back(row.y);
  }
  Means means;
  for (const auto& [series, by_x] : values) {
    for (const auto& [x, of] : by_x) {
      double sum = 0.0;
      for (const double value : of) sum += value;
      means[series][x] = sum / static_cast<double>(of.size());
    }
  }
  return means;
}

std::pair<std::string, double> most_of(const std::map<std::string, double>& by_x) {
  const auto most =
      std::ranges::max_element(by_x, {}, [](const auto& entry) { return entry.second; });
  return *most;
}

Chart states_chart(const Columns& columns, const std::vector<std::string>& units) {
  Chart chart;
  chart.id = "unit-states";
  chart.title = "What the units do with their cycles";
  chart.about = "Starved: waiting for input. Stalled: waiting for output or memory.";
  for (const std::string& unit : units) {
    for (const char* state : kStates) {
      const Column* column = columns.number(fmt::format("{}.{}_cycles", unit, state));
      if (column != nullptr) chart.measures.push_back({column, state, unit});
    }
  }
  chart.per = columns.number("cycles");
  chart.held = choose_held(columns, chart);
  Means means = means_of(columns, chart);
  const auto [busiest, share] = most_of(means["busy"]);
  chart.caption = fmt::format("{} is busiest: {} of the cycles.", busiest, percent_text(share));
  if (!means["stalled"].empty()) {
    const auto [stalled, part] = most_of(means["stalled"]);
    chart.caption += fmt::format(" {} is stalled most: {}.", stalled, percent_text(part));
  }
  chart.spec = new_spec(chart.title + ". " + chart.caption);
  const std::vector<std::string> states(kStates.begin(), kStates.end());
  Json& spec = chart.spec;
  spec["transform"] = Json::parse(R"json([
    {"aggregate": [{"op": "mean", "field": "y", "as": "share"}], "groupby": ["x", "s"]},
    {"calculate": "indexof(['busy', 'stalled', 'starved'], datum.s)", "as": "order"
}])json");
  spec["usermeta"]["symbols"] = "squares";
  spec["mark"] = {{"type", "bar"}, {"cursor", "pointer"}};
  spec["encoding"] = Json::parse(R"json({
    "y": {"field": "x", "type": "nominal", "title": null},
    "x": {"field": "share", "type": "quantitative", "title": "part of all cycles",
          "scale": {"domain": [0, 1]}, "axis": {"format": "%", "grid": true, "values": [0, 0.25, 0.5, 0.75, 1]}},
    "order": {"field": "order", "type": "quantitative"},
    "tooltip": [{"field": "x", "title": "unit"}, {"field": "s", "title": "state"},
                {"field": "share", "type": "quantitative", "format": ".1%",
                 "title": "part of all cycles"}]})json");
  spec["encoding"]["y"]["scale"] = {{"domain", units}};
  spec["encoding"]["color"] = colour_channel(states);
  spec["encoding"]["opacity"] = opacity_channel(1.0);
  return chart;
}

// The most that any point spends of its cycles; 0 if there is no such column.
double most_share(const Columns& columns, const Column* part) {
  const Column* cycles = columns.number("cycles");
  double most = 0.0;
  for (std::size_t i = 0; part != nullptr && i < columns.points(); ++i) {
    const double all = cycles->number(i).value_or(0.0);
    if (all > 0.0) most = std::max(most, part->number(i).value_or(0.0) / all);
  }
  return most;
}

// The parts of the critical path that are worth a column, along the pipeline: a unit's work, its
// memory, the queue behind it.
std::vector<Measure> path_parts(const Columns& columns) {
  constexpr double kLeastShare = 0.02;
  std::vector<Measure> parts;
  for (const std::string_view unit : model::kBlockUnits) {
    for (const auto& [prefix, suffix] :
         {std::pair("", ""), {"memory.", " memory"}, {"queue.", " queue"}}) {
      const Column* column = columns.number(fmt::format("path.{}{}", prefix, unit));
      if (most_share(columns, column) < kLeastShare) continue;
      const std::string name = fmt::format("{}{}", unit, suffix);
      parts.push_back({column, name, name});
    }
  }
  return parts;
}

// What the frame's end waited for (rows: values of an axis).
std::optional<Chart> bottleneck_chart(const Columns& columns, const std::vector<Measure>& parts,
                                      const Column* axis) {
  Chart chart;
  chart.id = "bottleneck-" + axis->key;
  chart.title = "Bottleneck, by " + axis->label;
  chart.about =
      "Part of the critical path: what the frame's last cycle waited for, unit by unit, memory and "
      "queues apart.";
  chart.series = axis;
  chart.measures = parts;
  chart.per = columns.number("cycles");
  chart.held = choose_held(columns, chart);
  Means means = means_of(columns, chart);
  if (means.size() < 2) return std::nullopt;
  std::vector<std::string> words;
  for (const Value& value : axis->distinct) {
    const auto& of_value = means[value_text(value)];
    if (of_value.empty()) continue;
    const auto [unit, share] = most_of(of_value);
    words.push_back(
        fmt::format("{} with {} ({})", unit, setting_text(*axis, value), percent_text(share)));
  }
  chart.caption = "Most: " + listed(words) + ".";
  chart.spec = new_spec(chart.title + ". " + chart.caption);
  const std::vector<std::string> rows = series_of(chart);
  Json& spec = chart.spec;
  spec["usermeta"]["symbols"] = "none";
  spec["height"] = kRowHeight * rows.size();
  spec["padding"] = {{"left", 4}, {"top", 4}, {"right", kSlantedLabel}, {"bottom", 4}};
  spec["transform"] = Json::parse(R"json([
    {"aggregate": [{"op": "mean", "field": "y", "as": "share"}], "groupby": ["x", "s"]}])json");
  spec["encoding"] = Json::parse(R"json({
    "x": {"field": "x", "type": "nominal", "title": null,
          "axis": {"labelAngle": -30, "orient": "top"}},
    "y": {"field": "s", "type": "nominal"}})json");
  std::vector<std::string> names;
  for (const Measure& part : parts) names.push_back(part.at);
  spec["encoding"]["x"]["scale"] = {{"domain", names}};
  spec["encoding"]["y"]["scale"] = {{"domain", rows}};
  spec["encoding"]["y"]["title"] = axis_title(axis->label, axis->unit);
  spec["layer"] = Json::parse(R"json([
    {"mark": {"type": "rect", "fill": "var(--series-0)", "cursor": "pointer"
}
, "encoding" : {
  "fillOpacity" : {
    "field" : "share", "type" : "quantitative", "legend" : null, "scale" : {
      "domain" : [ 0, 1 ], "range" : [ 0.06, 1.0 ]
    }
  }
}
},
    {"mark": {"type": "text", "cursor": "pointer"},
     "encoding": {"text": {"field": "share", "type": "quantitative", "format": ".0%"},
                  "color": {"value": "var(--ink)"}}}])json");
  spec["layer"][0]["encoding"]["opacity"] = opacity_channel(1.0);
  return chart;
}

}  // namespace

std::vector<Chart> unit_charts(const Columns& columns) {
  const std::vector<std::string> units = units_of(columns);
  if (units.empty() || columns.number("cycles") == nullptr) return {};
  std::vector<Chart> charts{states_chart(columns, units)};
  const std::vector<Measure> parts = path_parts(columns);
  if (parts.size() < 2) return charts;
  constexpr std::size_t kMostCharts = 4;
  constexpr std::size_t kMostRows = 16;
  for (const Column* axis : columns.axes()) {
    if (charts.size() == kMostCharts || axis->distinct.size() > kMostRows) continue;
    if (auto chart = bottleneck_chart(columns, parts, axis)) charts.push_back(*std::move(chart));
  }
  return charts;
}

}  // namespace wedgesim::reports::page
