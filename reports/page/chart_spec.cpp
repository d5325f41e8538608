#include "reports/page/chart_spec.h"

#include <algorithm>
#include <array>

#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

constexpr std::size_t kColours = 8;     // --series-0 ... of page.css
constexpr std::size_t kMostSteps = 16;  // beyond, numbers are drawn on a number line
constexpr int kHeight = 260;            // pixels

constexpr std::array<const char*, kColours> kShapes{"circle",        "square",        "diamond",
                                                    "triangle-up",   "triangle-down", "cross",
                                                    "triangle-left", "triangle-right"};

constexpr std::size_t kMostLetters = 48;  // of labels side by side

constexpr const char* kShortLabels =
    "datum.value == 0 ? '0' : abs(datum.value) < 0.001 ? format(datum.value, '~e') : "
    "abs(datum.value) < 10000 ? format(datum.value, ',.6~f') : format(datum.value, '.4~s')";
constexpr const char* kLogLabels =
    "indexof([1, 2, 5], round(datum.value / pow(10, floor(log(datum.value) / LN10 + 1e-9)))) < 0 ? "
    "'' : abs(datum.value) < 0.001 ? format(datum.value, '~e') : abs(datum.value) < 10000 ? "
    "format(datum.value, ',.6~f') : format(datum.value, '.4~s')";
constexpr const char* kByteLabels =
    "datum.value >= 1048576 ? datum.value / 1048576 + ' MiB' : "
    "datum.value >= 1024 ? datum.value / 1024 + ' KiB' : datum.value";

std::size_t letters_of(const Column& column) {
  std::size_t longest = 0;
  if (column.is_number()) return longest;
  for (const Value& value : column.distinct) {
    longest = std::max(longest, to_text(value).size() + 2);
  }
  return longest * column.distinct.size();
}

bool in_steps(const Column& column) {
  return !column.is_number() || column.distinct.size() <= kMostSteps;
}

}  // namespace

std::string axis_title(const std::string& label, const std::string& unit) {
  return unit.empty() ? label : label + " (" + unit + ")";
}

std::string y_title(const Chart& chart) {
  const Column& first = *chart.measures.front().column;
  if (chart.measures.size() == 1) return axis_title(first.label, first.unit);
  const bool same = std::ranges::all_of(
      chart.measures, [&first](const Measure& m) { return m.column->unit == first.unit; });
  return same ? first.unit : "";
}

Json new_spec(const std::string& description) {
  return {
      {"description", description},
      {"data", {{"name", "rows"}}},
      {"width", "container"},
      {"height", kHeight},
      {"autosize", {{"type", "fit-x"}, {"contains", "padding"}}},
      {"params",
       {{{"name", "chosen_s"}, {"value", nullptr}}, {{"name", "chosen_x"}, {"value", nullptr}}}},
      {"usermeta", {{"symbols", "shapes"}}}};
}

Json x_channel(const Column& column, bool log) {
  Json channel{{"field", "x"}, {"title", axis_title(column.label, column.unit)}};
  if (!log && in_steps(column)) {
    Json domain = Json::array();
    for (const Value& value : column.distinct) domain.push_back(to_json(value));
    channel["type"] = "ordinal";
    channel["scale"] = {{"type", "point"}, {"domain", domain}, {"padding", 0.5}};
    channel["axis"] = {{"labelAngle", letters_of(column) > kMostLetters ? -30 : 0}};
    if (column.is_number()) {
      channel["axis"]["labelOverlap"] = "greedy";
      channel["axis"]["labelExpr"] = column.unit == "bytes" ? kByteLabels : kShortLabels;
    }
    return channel;
  }
  channel["type"] = "quantitative";
  channel["scale"] = {{"nice", false}, {"padding", 12}};
  channel["scale"][log ? "type" : "zero"] = log ? Json("log") : Json(false);
  channel["axis"] = {
      {"labelExpr", log ? kLogLabels : kShortLabels}, {"tickCount", 6}, {"labelOverlap", "greedy"}};
  return channel;
}

Json y_channel(const std::string& field, const std::string& title, bool log, bool from_zero) {
  Json channel{{"field", field},
               {"type", "quantitative"},
               {"title", title},
               {"axis", {{"labelExpr", log ? kLogLabels : kShortLabels}, {"tickCount", 6}}}};
  if (log) channel["axis"]["labelOverlap"] = "greedy";
  channel["scale"][log ? "type" : "zero"] = log ? Json("log") : Json(from_zero);
  return channel;
}

Json colour_channel(const std::vector<std::string>& series) {
  Json range = Json::array();
  for (std::size_t i = 0; i < series.size(); ++i) {
    range.push_back("var(--series-" + std::to_string(i % kColours) + ")");
  }
  return {{"field", "s"},
          {"type", "nominal"},
          {"scale", {{"domain", series}, {"range", range}}},
          {"legend", nullptr}};
}

Json shape_channel(const std::vector<std::string>& series) {
  Json range = Json::array();
  // Another shape in each round of colours: no pair of them comes twice among 64 series.
  for (std::size_t i = 0; i < series.size(); ++i) {
    range.push_back(kShapes[(i + i / kColours) % kColours]);
  }
  return {{"field", "s"},
          {"type", "nominal"},
          {"scale", {{"domain", series}, {"range", range}}},
          {"legend", nullptr}};
}

Json opacity_channel(double full) {
  return {
      {"condition", {{"test", "!chosen_s || indexof(chosen_s, datum.s) >= 0"}, {"value", full}}},
      {"value", full * 0.12}};
}

Json spread_transform() {
  return {
      {{"quantile", "y"},
       {"probs", {0.05, 0.5, 0.95}},
       {"groupby", {"x", "s"}},
       {"as", {"p", "value"}}},
      {{"calculate", "datum.p < 0.3 ? 'low' : datum.p > 0.7 ? 'high' : 'median'"}, {"as", "part"}},
      {{"pivot", "part"}, {"value", "value"}, {"groupby", {"x", "s"}}}};
}

Json spread_tooltip(const Chart& chart) {
  const std::string format = ",.4~r";
  Json tooltip = Json::array();
  if (series_of(chart).size() > 1) {
    tooltip.push_back({{"field", "s"},
                       {"type", "nominal"},
                       {"title", chart.series == nullptr ? "shown" : chart.series->label}});
  }
  tooltip.push_back({{"field", "x"}, {"type", "nominal"}, {"title", chart.x->label}});
  for (const auto& [field, title] :
       {std::pair("median", "median"), {"low", "5th percentile"}, {"high", "95th percentile"}}) {
    tooltip.push_back(
        {{"field", field}, {"type", "quantitative"}, {"title", title}, {"format", format}});
  }
  return tooltip;
}

Json chosen_rule(const Json& x) {
  return {{"transform",
           {{{"filter", "chosen_x && indexof(chosen_x, datum.x) >= 0"}},
            {{"aggregate", Json::array()}, {"groupby", {"x"}}}}},
          {"mark", {{"type", "rule"}, {"stroke", "var(--ink-2)"}, {"strokeDash", {3, 3}}}},
          {"encoding", {{"x", x}}}};
}

Json chart_config() {
  const Json text = "var(--ink-2)";
  return {{"background", nullptr},
          {"font", "system-ui, sans-serif"},
          {"padding", 4},
          {"view", {{"stroke", nullptr}}},
          {"axis",
           {{"labelColor", text},
            {"titleColor", text},
            {"labelFontSize", 12},
            {"titleFontSize", 12},
            {"titleFontWeight", 500},
            {"titlePadding", 8},
            {"labelPadding", 6},
            {"gridColor", "var(--grid)"},
            {"domainColor", "var(--axis)"},
            {"tickColor", "var(--axis)"},
            {"tickSize", 4}}},
          {"axisX", {{"grid", false}}},
          {"axisY", {{"domain", false}, {"ticks", false}}},
          {"text", {{"color", text}, {"fontSize", 12}}}};
}

}  // namespace wedgesim::reports::page
