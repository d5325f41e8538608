#include "reports/page/caption.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

struct Extreme {
  std::string series;
  Value x;
  double median = 0.0;
};

std::string with_unit(double value, const std::string& unit) {
  return unit.empty() ? number_text(value) : number_text(value) + ' ' + unit;
}

std::string place_of(const Chart& chart, const Extreme& at) {
  const std::string x = setting_text(*chart.x, at.x);
  return at.series.empty() ? x : at.series + " at " + x;
}

// "Lowest: single-pass at tile 2, 253,000 words. Highest: ..."
std::string extremes_text(const Chart& chart, const std::vector<Line>& lines) {
  std::vector<Extreme> all;
  for (const Line& line : lines) {
    for (const auto& [x, spread] : line.at) all.push_back({line.series, x, spread.median});
  }
  const auto [least, most] = std::ranges::minmax_element(all, {}, &Extreme::median);
  const std::string unit = y_unit(chart);
  if (least->median == most->median) {
    return fmt::format("The median is {} everywhere.", with_unit(least->median, unit));
  }
  const bool more = chart.measures.front().column->better == Better::more;
  return fmt::format("{}: {}, {}. {}: {}, {}.", more ? "Highest" : "Lowest",
                     place_of(chart, more ? *most : *least),
                     with_unit(more ? most->median : least->median, unit),
                     more ? "Lowest" : "Highest", place_of(chart, more ? *least : *most),
                     with_unit(more ? least->median : most->median, unit));
}

std::string frames_text(const Columns& columns, const std::vector<Line>& lines) {
  std::size_t most = 0;
  for (const Line& line : lines) {
    for (const auto& [x, spread] : line.at) most = std::max(most, spread.count);
  }
  if (most == 1) return "";
  const std::size_t frames = columns.results().frames.size();
  return most == frames ? fmt::format("Medians over {} frames. ", frames)
                        : fmt::format("Medians over up to {} frames. ", most);
}

std::string trend_text(const Chart& chart, const std::vector<Line>& lines) {
  if (!chart.x->is_number()) return "";
  std::vector<std::string> parts;
  for (const Line& line : lines) {
    if (line.at.size() < 2 || line.at.front().second.median <= 0) continue;
    const double ratio = line.at.back().second.median / line.at.front().second.median;
    parts.push_back((line.series.empty() ? "" : line.series + " ") + change_text(ratio));
  }
  if (parts.empty() || parts.size() > 4) return "";
  return fmt::format(" From {} to {}: {}.", setting_text(*chart.x, lines.front().at.front().first),
                     value_text(lines.front().at.back().first), listed(parts));
}

}  // namespace

std::string y_unit(const Chart& chart) {
  const std::string& unit = chart.measures.front().column->unit;
  const bool same = std::ranges::all_of(
      chart.measures, [&unit](const Measure& m) { return m.column->unit == unit; });
  return same ? unit : "";
}

std::string change_text(double ratio) {
  if (std::abs(ratio - 1.0) < 0.0005) return "unchanged";
  if (ratio >= 2.0) return fmt::format("{}-fold", number_text(ratio));
  return fmt::format("{} {}", percent_text(std::abs(ratio - 1.0)), ratio > 1.0 ? "more" : "less");
}

std::string listed(const std::vector<std::string>& words) {
  std::string text;
  for (std::size_t i = 0; i < words.size(); ++i) {
    if (i > 0) text += i + 1 == words.size() ? " and " : ", ";
    text += words[i];
  }
  return text;
}

std::string line_caption(const Columns& columns, const Chart& chart) {
  const std::vector<Line> lines = lines_of(columns, chart);
  return frames_text(columns, lines) + extremes_text(chart, lines) + trend_text(chart, lines);
}

std::string bar_caption(const Columns& columns, const Chart& chart) {
  const std::vector<Line> lines = lines_of(columns, chart);
  return frames_text(columns, lines) + extremes_text(chart, lines);
}

std::string dot_caption(const Columns& columns, const Chart& chart, bool log) {
  std::map<std::string, std::vector<std::pair<double, double>>> points;
  std::vector<double> ys;
  for (const Row& row : rows_of(columns, chart)) {
    points[row.series].emplace_back(number_of(row.x).value_or(0.0), row.y);
    ys.push_back(row.y);
  }
  const auto [low, high] = std::ranges::minmax(ys);
  std::string text =
      fmt::format("{} points, from {} to {}.", number_text(static_cast<double>(ys.size())),
                  number_text(low), with_unit(high, y_unit(chart)));
  if (!log) return text;
  std::vector<std::string> slopes;
  for (const auto& [series, of_series] : points) {
    const auto slope = log_slope(of_series);
    if (slope)
      slopes.push_back((series.empty() ? "" : series + " ") + fmt::format("{:.2f}", *slope));
  }
  if (slopes.empty()) return text;
  return text + fmt::format(" Fitted slope on the log-log scale (1 is in proportion): {}.",
                            listed(slopes));
}

}  // namespace wedgesim::reports::page
