#include "reports/page/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <limits>
#include <map>

#include "reports/page/caption.h"
#include "reports/page/chart.h"
#include "reports/page/effects.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

// How cost grows with the frames' size and edges.
std::vector<std::string> slope_findings(const Columns& columns) {
  std::vector<std::string> found;
  for (const char* key : {"pixels", "wedges"}) {
    const auto chart = scaling_chart(columns, key);
    if (!chart) continue;
    std::map<std::string, std::vector<std::pair<double, double>>> points;
    double least = std::numeric_limits<double>::infinity(), most = 0.0;
    for (const Row& row : rows_of(columns, *chart)) {
      const double x = number_of(row.x).value_or(0.0);
      points[row.series].emplace_back(x, row.y);
      least = std::min(least, x);
      most = std::max(most, x);
    }
    std::vector<std::string> slopes;
    for (const auto& [series, of_series] : points) {
      if (const auto slope = log_slope(of_series)) {
        slopes.push_back(fmt::format("{:.2f}{}{}", *slope, series.empty() ? "" : " in ", series));
      }
    }
    if (slopes.empty()) continue;
    found.push_back(fmt::format("{} grow with the {}, from {} to {}, to the power {}.",
                                capital(chart->measures.front().column->label), chart->x->label,
                                number_text(least), number_text(most), listed(slopes)));
  }
  return found;
}

// "memory:z_read" as "z_read's memory".
std::string part_text(const std::string& part) {
  const std::size_t colon = part.find(':');
  if (colon == std::string::npos) return part;
  const std::string unit = part.substr(colon + 1);
  return part.starts_with("queue") ? "the queue behind " + unit
                                   : unit + "'s " + part.substr(0, colon);
}

std::vector<std::string> bottleneck_findings(const Columns& columns) {
  const Column* unit = columns.find("bottleneck");
  if (unit == nullptr || unit->distinct.empty()) return {};
  std::map<std::string, std::size_t> times;
  std::size_t all = 0;
  for (const Value& value : unit->values) {
    if (std::holds_alternative<std::monostate>(value)) continue;
    times[part_text(value_text(value))] += 1;
    all += 1;
  }
  std::vector<std::pair<std::size_t, std::string>> order;
  for (const auto& [name, count] : times) order.emplace_back(count, name);
  std::ranges::sort(order, std::greater());
  std::vector<std::string> parts;
  for (const auto& [count, name] : order) {
    if (parts.size() < 3) {
      parts.push_back(fmt::format("{} in {} of {} points", name, count, all));
    }
  }
  return {fmt::format("The bottleneck is {}.", listed(parts))};
}

// The most wrong pixels of any frame at each width of a format, all other widths as usual.
std::map<Value, double> wrong_pixels(const Columns& columns, const Column& format,
                                     const Column& wrong) {
  Chart chart;
  chart.x = &format;
  chart.measures = {{&wrong, ""}};
  chart.held = choose_held(columns, chart);
  std::erase_if(chart.held,
                [](const auto& hold) { return hold.first->kind != Column::Kind::setting; });
  std::map<Value, double> most;
  for (const Row& row : rows_of(columns, chart)) {
    double& pixels = most[row.x];
    pixels = std::max(pixels, row.y);
  }
  return most;
}

std::string width_text(const Column& format, const std::map<Value, double>& wrong) {
  // The narrowest from which on none is wrong.
  auto enough = wrong.end();
  while (enough != wrong.begin() && std::prev(enough)->second == 0.0) --enough;
  if (enough == wrong.end()) {
    return fmt::format("{}: {} are not enough, up to {} pixels of a frame go wrong", format.label,
                       value_text(wrong.rbegin()->first), number_text(wrong.rbegin()->second));
  }
  if (enough == wrong.begin()) {
    return fmt::format("{}: {}, the fewest tried, are enough", format.label,
                       value_text(enough->first));
  }
  const auto below = std::prev(enough);
  return fmt::format("{}: {} are enough, with {} pixels go wrong, up to {} in a frame",
                     format.label, value_text(enough->first), value_text(below->first),
                     number_text(below->second));
}

// The narrowest width of each format with every pixel within its tolerance.
std::vector<std::string> width_findings(const Columns& columns) {
  const Column* wrong = columns.number("mismatched");
  if (wrong == nullptr || !wrong->varies()) return {};
  std::vector<std::string> parts;
  for (const Column* format : columns.axes()) {
    if (!format->key.starts_with("formats.") || !format->is_number()) continue;
    const auto pixels = wrong_pixels(columns, *format, *wrong);
    if (pixels.size() > 1) parts.push_back(width_text(*format, pixels));
  }
  if (parts.empty()) return {};
  return {fmt::format("Bits. {}.", capital(fmt::format("{}", fmt::join(parts, "; "))))};
}

// What even the best leaves to be saved.
std::vector<std::string> floor_findings(const Columns& columns) {
  const Column* over = columns.number("over_floor");
  if (over == nullptr) return {};
  std::map<std::string, double> least;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    const auto value = over->number(i);
    if (!value) continue;
    const std::string& frame = columns.results().points[i].frame;
    const auto found = least.emplace(frame, *value).first;
    found->second = std::min(found->second, *value);
  }
  std::vector<double> values;
  for (const auto& [frame, value] : least) values.push_back(value);
  const auto spread = spread_of(values);
  if (!spread) return {};
  return {
      fmt::format("Even the best configuration of each frame makes {} times the "
                  "accesses of the floor (median; {} to {} over {} frames).",
                  number_text(spread->median), number_text(spread->low), number_text(spread->high),
                  spread->count)};
}

}  // namespace

std::vector<std::string> find_findings(const Columns& columns, std::size_t most) {
  std::vector<std::string> found;
  for (const auto find : {slope_findings, bottleneck_findings, mode_findings, width_findings,
                          culling_findings, setting_findings, floor_findings}) {
    std::ranges::move(find(columns), std::back_inserter(found));
  }
  if (found.size() > most) found.resize(most);
  return found;
}

}  // namespace wedgesim::reports::page
