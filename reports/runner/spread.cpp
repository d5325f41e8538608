#include "reports/runner/spread.h"

#include <algorithm>
#include <cmath>

#include "reports/runner/value.h"

namespace wedgesim::reports {

double quantile(const std::vector<double>& sorted, double fraction) {
  const double place = fraction * static_cast<double>(sorted.size() - 1);
  const auto below = static_cast<std::size_t>(place);
  const std::size_t above = std::min(below + 1, sorted.size() - 1);
  const double part = place - static_cast<double>(below);
  return sorted[below] + part * (sorted[above] - sorted[below]);
}

Spread spread_of(std::vector<double> values) {
  std::ranges::sort(values);
  return {quantile(values, 0.05), quantile(values, 0.5), quantile(values, 0.95)};
}

std::optional<Spread> PointGroup::spread(std::string_view metric) const {
  std::vector<double> values;
  for (const PointRow* point : points) {
    if (const auto number = number_of(find_value(point->metrics, metric))) {
      values.push_back(*number);
    }
  }
  if (values.empty()) return {};
  return spread_of(std::move(values));
}

Value frame_value(const FrameRow& frame, const std::string& key) {
  if (key == "scene") return frame.scene;
  if (key == "wedges") return frame.wedges;
  return find_value(frame.parameters, key);
}

std::vector<PointGroup> groups_of(const Results& results) {
  std::map<std::string, std::vector<Value>> by;  // of frames
  for (const FrameRow& frame : results.frames) {
    for (const std::string& key : results.study.by) {
      by[frame.label].push_back(frame_value(frame, key));
    }
  }
  std::vector<PointGroup> groups;
  std::map<std::tuple<std::vector<Value>, std::string, Values>, std::size_t> places;
  for (const PointRow& point : results.points) {
    if (point.state != PointState::done) continue;
    const auto [place, is_new] = places.try_emplace(
        std::tuple(by[point.frame], point.measure, point.configuration), groups.size());
    if (is_new) groups.push_back({by[point.frame], point.configuration, {}});
    groups[place->second].points.push_back(&point);
  }
  return groups;
}

}  // namespace wedgesim::reports
