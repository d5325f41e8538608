#include "reports/accuracy/accuracy_charts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "reports/accuracy/chart_labels.h"
#include "reports/accuracy/recommend.h"
#include "reports/page/caption.h"
#include "reports/page/chart_spec.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kLeast = 1e-6;    // smaller errors are drawn here
constexpr double kWidth = 270.0;   // of a narrow chart's plot, pixels: what fits there fits in all
constexpr double kHeight = 200.0;  // likewise

/// What a scatter shows errors over.
struct Axis {
  std::string id, title, unit;
  double units = 1.0;  // of the axis in one of the cost
  Cost cost = nullptr;
  std::string (*text)(double cost) = nullptr;
};

/// A range of a logarithmic scale.
struct Range {
  double low = 0.0, high = 0.0;
  double share(double value) const { return std::log(value / low) / std::log(high / low); }
};

// At least a factor of four, so that a lone mark has a scale; `margin`: of the range, either side.
Range range_of(const Json& rows, const char* field, double margin) {
  Range range{rows[0][field].get<double>(), rows[0][field].get<double>()};
  for (const Json& row : rows) {
    range.low = std::min(range.low, row[field].get<double>());
    range.high = std::max(range.high, row[field].get<double>());
  }
  const double more = std::max(std::pow(range.high / range.low, margin), 2.0);
  return {range.low / more, range.high * more};
}

Json rows_of(const SceneResult& result, const Axis& axis, const std::vector<std::size_t>& front) {
  Json rows = Json::array();
  std::vector<std::size_t> order = front;  // they are labelled first
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    if (std::ranges::find(front, i) == front.end()) order.push_back(i);
  }
  for (const std::size_t i : order) {
    const Measured& measured = result.methods[i];
    const double cost = measured.refused ? 0.0 : axis.cost(measured);
    if (cost <= 0.0) continue;
    rows.push_back({{"x", cost * axis.units},
                    {"x_text", axis.text(cost)},
                    {"s", measured.choice.method->name},
                    {"y", std::max(error_of(measured), kLeast)},
                    {"y_text", error_text(error_of(measured))},
                    {"case", measured.choice.text},
                    {"front", std::ranges::find(front, i) != front.end()}});
  }
  return rows;
}

void add_label_sides(Json& rows, const Range& x, const Range& y) {
  std::vector<LabelledMark> marks;
  for (const Json& row : rows) {
    marks.push_back({x.share(row["x"].get<double>()) * kWidth,
                     (1.0 - y.share(row["y"].get<double>())) * kHeight,
                     row["case"].get<std::string>(), row["front"].get<bool>()});
  }
  const auto sides = place_labels(marks, kWidth, kHeight);
  for (std::size_t i = 0; i < sides.size(); ++i) {
    if (sides[i]) rows[i]["side"] = static_cast<int>(*sides[i]);
  }
}

Json scaled(Json channel, const Range& range) {
  channel["scale"]["domain"] = {range.low, range.high};
  channel["scale"]["nice"] = false;
  channel["axis"]["labelSeparation"] = 5;
  return channel;
}

// The choices' names, at the side of their marks where they fit.
void add_labels(const Json& marks, Json& layers) {
  struct Place {
    Side side;
    const char* align;
    int dx, dy;
  };
  for (const Place& place :
       {Place{Side::right, "left", 8, 0}, Place{Side::left, "right", -8, 0},
        Place{Side::above, "center", 0, -12}, Place{Side::below, "center", 0, 13}}) {
    Json encoding{{"x", marks["x"]}, {"y", marks["y"]}, {"opacity", page::opacity_channel(1.0)}};
    encoding["text"] = {{"field", "case"}, {"type", "nominal"}};
    layers.push_back(
        {{"transform",
          {{{"filter", fmt::format("datum.side === {}", static_cast<int>(place.side))}}}},
         {"mark",
          {{"type", "text"},
           {"align", place.align},
           {"baseline", "middle"},
           {"dx", place.dx},
           {"dy", place.dy},
           {"fontSize", 11}}},
         {"encoding", encoding}});
  }
}

std::string caption_of(const SceneResult& result, const Axis& axis,
                       const std::vector<std::size_t>& front, std::size_t choices) {
  std::vector<std::string> parts;
  for (const std::size_t i : front) {
    const Measured& measured = result.methods[i];
    parts.push_back(fmt::format("{} {} in {}", measured.choice.text, error_text(error_of(measured)),
                                axis.text(axis.cost(measured))));
  }
  return fmt::format("{} of {} choices are on the front, which no other beats in both: {}.",
                     front.size(), choices, page::listed(parts));
}

page::RowChart scatter(const SceneResult& result, const std::string& label, const Axis& axis,
                       const std::vector<std::string>& methods) {
  page::RowChart chart{label + "-" + axis.id, "RMSE on receivers over " + axis.title, {}, {}, {}};
  const std::vector<std::size_t> front = pareto_front(result.methods, axis.cost);
  chart.rows = rows_of(result, axis, front);
  chart.caption = caption_of(result, axis, front, chart.rows.size());
  chart.spec = page::new_spec(fmt::format("{}: {}. {}", label, chart.title, chart.caption));
  if (chart.rows.empty()) return chart;
  const Range xs = range_of(chart.rows, "x", 0.02);
  const Range ys = range_of(chart.rows, "y", 0.08);
  add_label_sides(chart.rows, xs, ys);
  const Json x =
      scaled(page::y_channel("x", page::axis_title(axis.title, axis.unit), true, false), xs);
  const Json y = scaled(page::y_channel("y", "RMSE on receivers", true, false), ys);
  Json layers = Json::array();
  layers.push_back({{"transform", {{{"filter", "datum.front"}}}},
                    {"mark",
                     {{"type", "line"},
                      {"interpolate", "step-after"},
                      {"stroke", "var(--ink-2)"},
                      {"strokeDash", {4, 4}}}},
                    {"encoding", {{"x", x}, {"y", y}}}});
  Json marks = page::mark_channels(methods, x, y);
  marks["shape"] = page::shape_channel(methods);
  marks["tooltip"] = {page::tooltip_field("case", "choice"),
                      page::tooltip_field("y_text", "RMSE on receivers"),
                      page::tooltip_field("x_text", axis.title)};
  layers.push_back(
      {{"mark", {{"type", "point"}, {"filled", true}, {"size", 72}}}, {"encoding", marks}});
  add_labels(marks, layers);
  chart.spec["layer"] = std::move(layers);
  return chart;
}

// Three digits, as "1.23" or "1,230".
std::string three_digits(double value) {
  if (value >= 1000.0) return fmt::format("{:.0f}", value);
  return fmt::format("{:.3g}", value);
}

}  // namespace

std::vector<std::string> method_names(const std::vector<SceneResult>& results) {
  std::set<std::string_view> used;
  for (const SceneResult& result : results) {
    for (const Measured& measured : result.methods) used.insert(measured.choice.method->name);
  }
  std::vector<std::string> names;
  for (const functional::Method& method : functional::methods()) {
    if (used.contains(method.name)) names.emplace_back(method.name);
  }
  return names;
}

std::string error_text(double error) {
  if (!std::isfinite(error)) return "no number";
  return error == 0.0 || error >= 1e-4 ? fmt::format("{:.4f}", error)
                                       : fmt::format("{:.1e}", error);
}

std::string time_text(double seconds) { return three_digits(1e3 * seconds) + " ms"; }

std::string bytes_text(double bytes) { return three_digits(1e-6 * bytes) + " MB"; }

page::RowChart time_chart(const SceneResult& result, const std::string& label,
                          const std::vector<std::string>& methods) {
  return scatter(result, label,
                 {"time", "run time on all threads", "ms", 1e3, seconds_of, time_text}, methods);
}

page::RowChart bytes_chart(const SceneResult& result, const std::string& label,
                           const std::vector<std::string>& methods) {
  return scatter(result, label,
                 {"bytes", "bytes read and written", "MB", 1e-6, bytes_of, bytes_text}, methods);
}

}  // namespace wedgesim::reports::accuracy
