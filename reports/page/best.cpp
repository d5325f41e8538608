#include <algorithm>
#include <map>

#include "reports/page/findings.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

using Settings = std::vector<Value>;  // of the axes that are settings

std::vector<const Column*> setting_axes(const Columns& columns) {
  std::vector<const Column*> axes;
  for (const Column* axis : columns.axes()) {
    if (axis->kind == Column::Kind::setting) axes.push_back(axis);
  }
  return axes;
}

bool is_usable(const Columns& columns, const Column& metric, std::size_t point) {
  if (!columns.done(point) || !metric.number(point)) return false;
  const Column* wrong = columns.number("mismatched");
  return wrong == nullptr || wrong->number(point).value_or(0.0) == 0.0;
}

/// Values of a metric by configuration and frame, turned so that less is better.
struct Scores {
  std::map<Settings, std::map<std::string, double>> by_settings;
  std::map<std::string, double> best;  // by frame
};

Scores scores_of(const Columns& columns, const Column& metric,
                 const std::vector<const Column*>& axes) {
  Scores scores;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    if (!is_usable(columns, metric, i)) continue;
    Settings settings;
    for (const Column* axis : axes) settings.push_back(axis->values[i]);
    const std::string& frame = columns.results().points[i].frame;
    double score = *metric.number(i);
    if (metric.better == Better::more) score = score > 0.0 ? 1.0 / score : 1e300;
    scores.by_settings[settings][frame] = score;
    const auto best = scores.best.emplace(frame, score).first;
    best->second = std::min(best->second, score);
  }
  return scores;
}

}  // namespace

const Column* judging_metric(const Columns& columns) {
  for (const char* key : {"format_bits", "cycles", "all_bytes", "accesses"}) {
    const Column* column = columns.number(key);
    if (column != nullptr && column->varies()) return column;
  }
  for (const std::string& key : columns.results().study.metrics) {
    const Column* column = columns.number(key);
    if (column != nullptr && column->varies() && column->better != Better::neither) return column;
  }
  return nullptr;
}

std::optional<Best> find_best(const Columns& columns) {
  const Column* metric = judging_metric(columns);
  const std::vector<const Column*> axes = setting_axes(columns);
  if (metric == nullptr || axes.empty()) return std::nullopt;
  const Scores scores = scores_of(columns, *metric, axes);
  std::size_t frames = 0;
  for (const auto& [settings, by_frame] : scores.by_settings) {
    frames = std::max(frames, by_frame.size());
  }
  std::optional<Best> best;
  for (const auto& [settings, by_frame] : scores.by_settings) {
    if (by_frame.size() < frames) continue;
    std::vector<double> behind, values;
    for (const auto& [frame, score] : by_frame) {
      behind.push_back(scores.best.at(frame) > 0.0 ? score / scores.best.at(frame) : 1.0);
      values.push_back(metric->better == Better::more ? 1.0 / score : score);
    }
    const Spread spread = *spread_of(behind);
    if (best && std::pair(spread.median, spread.high) >=
                    std::pair(best->behind.median, best->behind.high)) {
      continue;
    }
    best = Best{metric, {}, *spread_of(values), spread};
    for (std::size_t k = 0; k < axes.size(); ++k) best->settings.emplace_back(axes[k], settings[k]);
  }
  return best;
}

}  // namespace wedgesim::reports::page
