#include "reports/stress/stress_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "reports/page/caption.h"
#include "reports/page/chart_spec.h"
#include "reports/stress/case_name.h"
#include "reports/stress/levels.h"

namespace wedgesim::reports::stress {
namespace {

constexpr double kLeast = 1e-12;  // smaller errors are drawn here
constexpr double kMost = 1e4;     // larger ones here

// Labels of a logarithmic axis.
constexpr const char* kPowers =
    "datum.value > 0.5 && datum.value < 5000 ? format(datum.value, '.0f') : "
    "replace(replace(format(datum.value, '.0e'), '+', ''), '−', '-')";

const std::vector<std::string>& names() {
  static const std::vector<std::string> all(kArithmeticNames.begin(), kArithmeticNames.end());
  return all;
}

std::string family_name(const FamilyResult& result) { return std::string(result.family->name); }

double drawn(double error) {
  if (!std::isfinite(error)) return kMost;
  return std::clamp(error, kLeast, kMost);
}

Json level_channel(const Family& family) {
  Json domain = Json::array();
  for (const double level : family.levels) domain.push_back(difficulty_text(level));
  const std::string title(family.unit.empty() ? "difficulty" : family.unit);
  return {{"field", "x"},
          {"type", "ordinal"},
          {"title", title},
          {"scale", {{"type", "point"}, {"domain", domain}, {"padding", 0.5}}},
          {"axis", {{"labelAngle", 0}, {"labelOverlap", "greedy"}}}};
}

Json error_channel(const std::string& title, const Json& rows) {
  double top = 1.0;
  for (const Json& row : rows) {
    while (row["y"].get<double>() > top) top *= 100.0;
  }
  Json ticks = Json::array();
  for (double tick = kLeast; tick < 2.0 * top; tick *= 100.0) ticks.push_back(tick);
  return {{"field", "y"},
          {"type", "quantitative"},
          {"title", title},
          {"scale", {{"type", "log"}, {"domain", {kLeast, top}}, {"nice", false}}},
          {"axis",
           {{"values", ticks},
            {"labelExpr", fmt::format("datum.value < {} ? '≤ {}' : {}", 2.0 * kLeast,
                                      difficulty_text(kLeast), kPowers)}}}};
}

// A horizontal rule at each bar, its name at the left.
Json bar_layers(const std::vector<std::pair<double, std::string>>& bars) {
  Json values = Json::array();
  for (const auto& [y, text] : bars) values.push_back({{"y", y}, {"text", text}});
  const Json data{{"values", values}};
  const Json y{{"field", "y"}, {"type", "quantitative"}};
  return {
      {{"data", data},
       {"mark", {{"type", "rule"}, {"stroke", "var(--ink-2)"}, {"strokeDash", {2, 3}}}},
       {"encoding", {{"y", y}}}},
      {{"data", data},
       {"mark", {{"type", "text"}, {"align", "left"}, {"dx", 3}, {"dy", -6}, {"fontSize", 11}}},
       {"encoding",
        {{"x", {{"value", 0}}}, {"y", y}, {"text", {{"field", "text"}, {"type", "nominal"}}}}}}};
}

// A vertical rule at the hardest level that each arithmetic must hold, side by side.
void add_required(const FamilyResult& result, const Json& x, Json& layers) {
  double offset = -3.0;
  for (const Arithmetic a :
       {Arithmetic::fixed, Arithmetic::double_precision, Arithmetic::renderer}) {
    const auto required = result.required(a);
    if (required) {
      const Json row{{"x", difficulty_text(*required)}, {"s", std::string(name_of(a))}};
      layers.push_back(
          {{"data", {{"values", Json::array({row})}}},
           {"mark",
            {{"type", "rule"}, {"strokeDash", {6, 3}}, {"strokeWidth", 1.5}, {"xOffset", offset}}},
           {"encoding",
            {{"x", x},
             {"color", page::colour_channel(names())},
             {"opacity", page::opacity_channel(0.7)}}}});
    }
    offset += 3.0;
  }
}

Json tooltip(const std::string& x_title, const std::string& y_title, bool with_case) {
  Json fields = Json::array();
  if (with_case) fields.push_back(page::tooltip_field("case", "case"));
  fields.push_back(page::tooltip_field("s", "arithmetic"));
  fields.push_back(page::tooltip_field("x_text", x_title));
  fields.push_back(page::tooltip_field("y_text", y_title));
  return fields;
}

Json row_of(Json x, const std::string& x_text, Arithmetic arithmetic, double error) {
  return {{"x", std::move(x)},
          {"x_text", x_text},
          {"s", std::string(name_of(arithmetic))},
          {"y", drawn(error)},
          {"y_text", error_text(error)}};
}

page::RowChart level_chart(const FamilyResult& result, double Errors::*what, page::RowChart chart,
                           const std::vector<std::pair<double, std::string>>& bars) {
  const Family& family = *result.family;
  chart.rows = Json::array();
  std::vector<std::string> parts;
  for (const Arithmetic a : kArithmetics) {
    double first = 0.0;
    double last = 0.0;
    for (std::size_t i = 0; i < family.levels.size(); ++i) {
      const auto& seeds = result.levels[i];
      const bool none =
          std::ranges::all_of(seeds, [](const auto& m) { return m.refused.has_value(); });
      if (none) continue;
      last = worst_of(seeds, a).*what;
      if (i == 0) first = last;
      const std::string level = difficulty_text(family.levels[i]);
      chart.rows.push_back(row_of(level, level, a, last));
    }
    parts.push_back(
        fmt::format("{} from {} to {}", name_of(a), error_text(first), error_text(last)));
  }
  chart.caption = "From the first difficulty to the last: " + page::listed(parts) + ".";
  chart.spec = page::new_spec(fmt::format("{}: {}. {}", family.name, chart.title, chart.caption));
  const Json x = level_channel(family);
  const Json y = error_channel("LI error", chart.rows);
  Json layers = bar_layers(bars);
  add_required(result, x, layers);
  layers.push_back({{"mark", {{"type", "line"}, {"strokeWidth", 2}}},
                    {"encoding", page::mark_channels(names(), x, y)}});
  Json points = page::mark_channels(names(), x, y);
  points["shape"] = page::shape_channel(names());
  points["tooltip"] = tooltip(std::string(family.parameter), chart.title, false);
  layers.push_back(
      {{"mark", {{"type", "point"}, {"filled", true}, {"size", 48}}}, {"encoding", points}});
  chart.spec["layer"] = std::move(layers);
  return chart;
}

Json log_channel(const std::string& title, bool powers) {
  Json channel{{"field", "x"},
               {"type", "quantitative"},
               {"title", title},
               {"scale", {{"type", "log"}, {"nice", false}, {"padding", 12}}},
               {"axis", {{"tickCount", 6}, {"labelOverlap", "greedy"}}}};
  if (powers) channel["axis"]["labelExpr"] = kPowers;
  return channel;
}

// Marks of all families, with what else is drawn.
void fill_scatter(page::RowChart& chart, const std::string& x_title, Json x,
                  const std::string& y_title, Json layers) {
  chart.spec = page::new_spec(chart.title + ". " + chart.caption);
  Json dots = page::mark_channels(names(), std::move(x), error_channel(y_title, chart.rows));
  dots["opacity"] = page::opacity_channel(0.75);
  dots["shape"] = page::shape_channel(names());
  dots["tooltip"] = tooltip(x_title, y_title, true);
  layers.push_back(
      {{"mark", {{"type", "point"}, {"filled", true}, {"size", 40}}}, {"encoding", dots}});
  chart.spec["layer"] = std::move(layers);
}

// How many levels all arithmetics are compared over: to the hardest that `fixed` must hold.
std::size_t compared_levels(const FamilyResult& result) {
  const auto required = result.required(Arithmetic::fixed);
  return required ? result.levels_up_to(*required) : result.levels.size();
}

// A line of the rounding unit times the condition number.
Json unit_layers(double largest) {
  Json layers = Json::array();
  for (const auto& [unit, text] : {std::pair(std::ldexp(1.0, -53), "2⁻⁵³ × condition"),
                                   std::pair(std::ldexp(1.0, -24), "2⁻²⁴ × condition")}) {
    const double least = std::max(1.0, kLeast / unit);
    const double most = std::min(largest, kMost / unit);
    if (most <= least) continue;
    const Json values{{{"x", least}, {"y", least * unit}}, {{"x", most}, {"y", most * unit}}};
    const Json x{{"field", "x"}, {"type", "quantitative"}};
    const Json y{{"field", "y"}, {"type", "quantitative"}};
    layers.push_back(
        {{"data", {{"values", values}}},
         {"mark", {{"type", "line"}, {"stroke", "var(--ink-2)"}, {"strokeDash", {4, 4}}}},
         {"encoding", {{"x", x}, {"y", y}}}});
    layers.push_back({{"data", {{"values", Json::array({values.back()})}}},
                      {"mark",
                       {{"type", "text"},
                        {"align", "right"},
                        {"dx", -10},
                        {"dy", -8},
                        {"fontSize", 11},
                        {"text", text}}},
                      {"encoding", {{"x", x}, {"y", y}}}});
  }
  return layers;
}

}  // namespace

std::string error_text(double error) {
  if (!std::isfinite(error)) return "no number";
  if (error == 0.0) return "0";
  if (error >= 0.01 && error < 1000.0) return fmt::format("{:.2g}", error);
  std::string text = fmt::format("{:.1e}", error);
  const std::size_t zero = text.find_last_of("+-") + 1;
  if (text[zero] == '0') text.erase(zero, 1);
  return text;
}

page::RowChart excess_chart(const FamilyResult& result) {
  page::RowChart chart{
      family_name(result) + "-excess", "Largest error beyond sensitivity", {}, {}, {}};
  return level_chart(result, &Errors::max_excess, std::move(chart),
                     {{tolerance_of(Arithmetic::fixed), "bar of fixed, float32"},
                      {tolerance_of(Arithmetic::double_precision), "bar of double, renderer"}});
}

page::RowChart rms_chart(const FamilyResult& result) {
  page::RowChart chart{family_name(result) + "-rms", "RMS error", {}, {}, {}};
  return level_chart(result, &Errors::rms, std::move(chart),
                     {{kLargestRms, "bar of fixed, float32"}});
}

page::RowChart time_chart(const std::vector<FamilyResult>& results) {
  page::RowChart chart{"time", "RMS error over run time", {}, {}, Json::array()};
  std::vector<std::string> parts;
  for (const Arithmetic a :
       {Arithmetic::fixed, Arithmetic::float32, Arithmetic::double_precision}) {
    std::vector<double> times;
    std::vector<double> errors;
    for (const FamilyResult& result : results) {
      const auto time = nanoseconds_of(result, a);
      if (!time) continue;
      double error = 0.0;
      for (std::size_t i = 0; i < compared_levels(result); ++i) {
        error = std::max(error, worst_of(result.levels[i], a).rms);
      }
      times.push_back(*time);
      errors.push_back(error);
      Json row = row_of(*time, fmt::format("{:.3g} ns", *time), a, error);
      row["case"] = result.family->name;
      chart.rows.push_back(std::move(row));
    }
    if (times.empty()) continue;
    parts.push_back(fmt::format("{} {:.3g} ns and an RMS error of {}", name_of(a), median_of(times),
                                error_text(median_of(errors))));
  }
  chart.caption =
      "A mark is a family: the median time of a contribution, one thread, and the "
      "largest RMS error of the difficulties that fixed must hold. Medians over "
      "families: " +
      page::listed(parts) + ".";
  fill_scatter(chart, "time of a contribution", log_channel("time of a contribution (ns)", false),
               "RMS error", Json::array());
  return chart;
}

page::RowChart condition_chart(const std::vector<FamilyResult>& results) {
  page::RowChart chart{"condition", "Error over condition number", {}, {}, Json::array()};
  double largest = 1.0;
  for (const FamilyResult& result : results) {
    for (std::size_t i = 0; i < result.levels.size(); ++i) {
      const double condition = condition_of(result.levels[i]);
      if (!std::isfinite(condition)) continue;
      largest = std::max(largest, condition);
      for (const Arithmetic a : kArithmetics) {
        Json row =
            row_of(condition, error_text(condition), a, worst_of(result.levels[i], a).max_excess);
        row["case"] =
            fmt::format("{} {}", result.family->name, difficulty_text(result.family->levels[i]));
        chart.rows.push_back(std::move(row));
      }
    }
  }
  chart.caption = fmt::format(
      "A mark is a difficulty of a family: the largest relative change of a shadow quad's normal "
      "for a relative change of the input's coordinates, up to {}, and the largest error beyond "
      "sensitivity. Lines: that number times one rounding of the input in double and in single "
      "precision.",
      error_text(largest));
  fill_scatter(chart, "condition number", log_channel("condition number", true),
               "LI error beyond sensitivity", unit_layers(largest));
  return chart;
}

}  // namespace wedgesim::reports::stress
