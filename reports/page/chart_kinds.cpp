#include <algorithm>

#include "reports/page/caption.h"
#include "reports/page/chart.h"
#include "reports/page/chart_spec.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

std::string description_of(const Chart& chart) {
  return chart.title + ". " + chart.about + " " + chart.caption;
}

// Values far apart, and none of them 0, are drawn on a logarithmic scale.
bool spans_decades(const std::vector<double>& values) {
  constexpr double kFar = 30.0;
  const auto [low, high] = std::ranges::minmax(values);
  return low > 0.0 && high > kFar * low;
}

bool spans_decades(const std::vector<Line>& lines) {
  std::vector<double> medians;
  for (const Line& line : lines) {
    for (const auto& [x, spread] : line.at) {
      if (spread.low <= 0.0) return false;  // the band would have no end
      medians.push_back(spread.median);
    }
  }
  return spans_decades(medians);
}

bool spans_decades(const std::vector<Row>& rows) {
  std::vector<double> values;
  for (const Row& row : rows) values.push_back(row.y);
  return spans_decades(values);
}

bool starts_at_zero(const Chart& chart) {
  return std::ranges::none_of(
      chart.measures, [](const Measure& m) { return m.column->key == "frames_per_second"; });
}

bool has_two(const std::vector<Row>& rows, std::size_t at_least_x) {
  std::vector<Value> xs;
  for (const Row& row : rows) xs.push_back(row.x);
  std::ranges::sort(xs);
  const auto rest = std::ranges::unique(xs);
  return static_cast<std::size_t>(rest.begin() - xs.begin()) >= at_least_x;
}

}  // namespace

std::optional<Chart> finish_lines(const Columns& columns, Chart chart) {
  chart.held = choose_held(columns, chart);
  const std::vector<Row> rows = rows_of(columns, chart);
  if (!has_two(rows, 2)) return std::nullopt;
  chart.caption = line_caption(columns, chart);
  const std::vector<std::string> series = series_of(chart);
  const bool log = spans_decades(lines_of(columns, chart));
  const Json x = x_channel(*chart.x, false);
  const Json y = y_channel("median", y_title(chart), log, starts_at_zero(chart));
  Json band_y = y;
  band_y["field"] = "low";
  const Json colour = colour_channel(series);
  chart.spec = new_spec(description_of(chart));
  chart.spec["transform"] = spread_transform();
  chart.spec["layer"] = {
      chosen_rule(x),
      {{"mark", {{"type", "area"}}},
       {"encoding",
        {{"x", x},
         {"y", band_y},
         {"y2", {{"field", "high"}}},
         {"color", colour},
         {"opacity", opacity_channel(0.16)}}}},
      {{"mark", {{"type", "line"}, {"strokeWidth", 2}}},
       {"encoding", {{"x", x}, {"y", y}, {"color", colour}, {"opacity", opacity_channel(1.0)}}}},
      {{"mark", {{"type", "point"}, {"filled", true}, {"size", 64}, {"cursor", "pointer"}}},
       {"encoding",
        {{"x", x},
         {"y", y},
         {"color", colour},
         {"shape", shape_channel(series)},
         {"opacity", opacity_channel(1.0)},
         {"tooltip", spread_tooltip(chart)}}}}};
  return chart;
}

std::optional<Chart> finish_bars(const Columns& columns, Chart chart) {
  chart.held = choose_held(columns, chart);
  const std::vector<Row> rows = rows_of(columns, chart);
  if (!has_two(rows, 2)) return std::nullopt;
  chart.caption = bar_caption(columns, chart);
  const std::vector<std::string> series = series_of(chart);
  Json x = x_channel(*chart.x, false);
  if (x["type"] == "quantitative") return finish_lines(columns, std::move(chart));
  x["scale"] = {{"type", "band"}, {"domain", x["scale"]["domain"]}, {"paddingInner", 0.25}};
  const Json offset{{"field", "s"}, {"scale", {{"domain", series}}}};
  const Json y = y_channel("median", y_title(chart), false, true);
  Json low = y;
  low["field"] = "low";
  chart.spec = new_spec(description_of(chart));
  chart.spec["usermeta"]["symbols"] = "squares";
  chart.spec["transform"] = spread_transform();
  chart.spec["layer"] = {
      {{"mark", {{"type", "bar"}, {"cursor", "pointer"}}},
       {"encoding",
        {{"x", x},
         {"xOffset", offset},
         {"y", y},
         {"color", colour_channel(series)},
         {"opacity", opacity_channel(1.0)},
         {"tooltip", spread_tooltip(chart)}}}},
      {{"mark", {{"type", "rule"}, {"stroke", "var(--ink)"}, {"strokeWidth", 1.5}}},
       {"encoding",
        {{"x", x},
         {"xOffset", offset},
         {"y", low},
         {"y2", {{"field", "high"}}},
         {"opacity", opacity_channel(1.0)}}}}};
  return chart;
}

std::optional<Chart> finish_dots(const Columns& columns, Chart chart, bool log) {
  // Metric against metric: every point, whatever its settings.
  if (chart.x->kind != Column::Kind::metric) chart.held = choose_held(columns, chart);
  const std::vector<Row> rows = rows_of(columns, chart);
  if (!has_two(rows, 2)) return std::nullopt;
  chart.caption = dot_caption(columns, chart, log);
  const std::vector<std::string> series = series_of(chart);
  Json x = x_channel(*chart.x, log);
  const bool log_y = log || spans_decades(rows);
  const Json y = y_channel("y", y_title(chart), log_y, starts_at_zero(chart));
  const Json colour = colour_channel(series);
  const Json tooltip{
      {{"field", "frame"}, {"type", "nominal"}},
      {{"field", "s"}, {"type", "nominal"}, {"title", "series"}},
      {{"field", "x"}, {"type", "nominal"}, {"title", chart.x->label}},
      {{"field", "y"}, {"type", "quantitative"}, {"title", y_title(chart)}, {"format", ",.4~r"}}};
  chart.spec = new_spec(description_of(chart));
  Json dots{{"mark", {{"type", "point"}, {"filled", true}, {"size", 40}, {"cursor", "pointer"}}},
            {"encoding",
             {{"x", x},
              {"y", y},
              {"color", colour},
              {"shape", shape_channel(series)},
              {"opacity", opacity_channel(0.75)},
              {"tooltip", tooltip}}}};
  chart.spec["layer"] = Json::array({dots});
  if (log) {
    chart.spec["layer"].push_back(
        {{"transform", {{{"regression", "y"}, {"on", "x"}, {"method", "pow"}, {"groupby", {"s"}}}}},
         {"mark", {{"type", "line"}, {"strokeDash", {6, 4}}}},
         {"encoding", {{"x", x}, {"y", y}, {"color", colour}, {"opacity", opacity_channel(1.0)}}}});
  }
  return chart;
}

}  // namespace wedgesim::reports::page
