#include "reports/page/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <iterator>
#include <map>

#include "reports/page/caption.h"
#include "reports/page/effects.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

// What a slope is stated of: less may come from what else differs between frames.
constexpr double kLeastRange = 10.0;
constexpr double kLeastEdgeRange = 100.0;

// How cost grows with the frame's size and edges.
std::vector<std::string> slope_findings(const Columns& columns) {
  std::vector<std::string> found;
  const Column* cost = columns.number("cycles");
  if (cost == nullptr) cost = columns.number("accesses");
  if (cost == nullptr) return found;
  for (const char* key : {"pixels", "wedges"}) {
    const Column* x = columns.number(key);
    if (x == nullptr || x->range() < (x->key == "wedges" ? kLeastEdgeRange : kLeastRange)) {
      continue;
    }
    if (x->key == "pixels" && columns.axis("size") == nullptr) continue;
    std::vector<std::pair<double, double>> points;
    for (std::size_t i = 0; i < columns.points(); ++i) {
      if (x->number(i) && cost->number(i)) points.emplace_back(*x->number(i), *cost->number(i));
    }
    const auto slope = log_slope(points);
    if (!slope) continue;
    found.push_back(
        fmt::format("{} grow with the {} to the power {:.2f}, from {} to {} of them: {}.",
                    columns.number("cycles") == cost ? "Cycles" : "Accesses", x->label, *slope,
                    value_text(x->distinct.front()), value_text(x->distinct.back()),
                    *slope > 1.05   ? "more than in proportion"
                    : *slope < 0.95 ? "less than in proportion"
                                    : "in proportion"));
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

// The narrowest width of each format with every pixel within its tolerance.
std::vector<std::string> width_findings(const Columns& columns) {
  const Column* wrong = columns.number("mismatched");
  if (wrong == nullptr || !wrong->varies()) return {};
  std::vector<std::string> parts;
  for (const Column* format : columns.axes()) {
    if (!format->key.starts_with("formats.") || !format->is_number()) continue;
    std::map<Value, double> worst;
    for (std::size_t i = 0; i < columns.points(); ++i) {
      if (const auto pixels = wrong->number(i)) {
        double& most = worst[format->values[i]];
        most = std::max(most, *pixels);
      }
    }
    const auto enough =
        std::ranges::find_if(worst, [](const auto& entry) { return entry.second == 0.0; });
    // Other widths may be at fault at every value of this one: then it says nothing.
    if (enough == worst.end()) {
      continue;
    } else if (enough == worst.begin()) {
      parts.push_back(fmt::format("{}: {} bits, the fewest tried, are enough", format->label,
                                  value_text(enough->first)));
    } else {
      const auto below = std::prev(enough);
      parts.push_back(fmt::format("{}: {} bits are enough, with {} up to {} pixels are wrong",
                                  format->label, value_text(enough->first),
                                  value_text(below->first), number_text(below->second)));
    }
  }
  if (parts.empty()) return {};
  return {capital(fmt::format("{}", fmt::join(parts, "; "))) + "."};
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
