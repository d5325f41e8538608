#include "reports/page/chart.h"

#include <algorithm>
#include <map>
#include <optional>
#include <set>
#include <tuple>

#include "reports/page/findings.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

bool draws(const Chart& chart, const Column* column) {
  if (column == chart.x || column == chart.series) return true;
  return std::ranges::any_of(chart.measures,
                             [column](const Measure& m) { return m.column == column; });
}

std::string series_at(const Chart& chart, const Measure& measure, std::size_t point) {
  if (chart.series != nullptr) return value_text(chart.series->values[point]);
  return chart.measures.size() > 1 ? measure.name : "";
}

bool has_value(const Value& value) { return !std::holds_alternative<std::monostate>(value); }

// Takes every point of every measure that has both x and y.
template <typename Take>
void for_each_row(const Columns& columns, const Chart& chart, Take take) {
  for (std::size_t i = 0; i < columns.points(); ++i) {
    if (!columns.done(i)) continue;
    const double per = chart.per == nullptr ? 1.0 : chart.per->number(i).value_or(0.0);
    for (const Measure& measure : chart.measures) {
      const auto y = measure.column->number(i);
      Value x = chart.x == nullptr ? Value(measure.at) : chart.x->values[i];
      if (!y || per == 0.0 || !has_value(x)) continue;
      take(i, Row{std::move(x), series_at(chart, measure, i), *y / per});
    }
  }
}

bool is_setting(const Best& best, const Column* column, const Value& value) {
  return std::ranges::find(best.settings, std::pair(column, value)) != best.settings.end();
}

// Over the frames' size: the scene that has most sizes, unless all have the same. Over another of
// their parameters: the size that has most of its values.
std::optional<std::pair<const Column*, Value>> choose_frames(const Columns& columns,
                                                             const Chart& chart) {
  if (chart.x == nullptr || chart.x->kind != Column::Kind::frame) return std::nullopt;
  const bool over_size = chart.x->key == "pixels" || chart.x->key == "size";
  const Column* by = columns.find(over_size ? "scene" : "size");
  if (by == nullptr || by == chart.x || by == chart.series || !by->varies()) return std::nullopt;
  std::map<Value, std::set<Value>> values;
  for_each_row(columns, chart,
               [&](std::size_t point, const Row& row) { values[by->values[point]].insert(row.x); });
  if (values.empty()) return std::nullopt;
  const auto size_of = [](const auto& entry) { return entry.second.size(); };
  const auto most = std::ranges::max_element(values, {}, size_of);
  const bool same = std::ranges::all_of(
      values, [&most](const auto& entry) { return entry.second == most->second; });
  if (same && over_size) return std::nullopt;
  return std::pair(by, most->first);
}

bool is_held(const Held& held, std::size_t point) {
  return std::ranges::all_of(
      held, [point](const auto& hold) { return hold.first->values[point] == hold.second; });
}

}  // namespace

std::vector<Row> rows_of(const Columns& columns, const Chart& chart) {
  std::vector<Row> rows;
  for_each_row(columns, chart, [&](std::size_t point, Row row) {
    if (is_held(chart.held, point)) rows.push_back(std::move(row));
  });
  return rows;
}

std::vector<std::string> series_of(const Chart& chart) {
  std::vector<std::string> names;
  if (chart.series != nullptr) {
    for (const Value& value : chart.series->distinct) names.push_back(value_text(value));
  } else if (chart.measures.size() > 1) {
    for (const Measure& measure : chart.measures) {
      if (std::ranges::find(names, measure.name) == names.end()) names.push_back(measure.name);
    }
  }
  if (names.empty()) names.emplace_back();
  return names;
}

Held choose_held(const Columns& columns, const Chart& chart) {
  std::vector<const Column*> free;
  // Over one parameter of frames, others of them differ too.
  const bool over_frames = chart.x != nullptr && chart.x->kind == Column::Kind::frame;
  for (const Column* axis : columns.axes()) {
    if (over_frames && axis->kind == Column::Kind::frame) continue;
    if (!draws(chart, axis)) free.push_back(axis);
  }
  std::map<std::vector<Value>, std::set<std::pair<Value, std::string>>> seen;
  for_each_row(columns, chart, [&](std::size_t point, const Row& row) {
    std::vector<Value> values;
    for (const Column* axis : free) values.push_back(axis->values[point]);
    seen[values].emplace(chart.x == nullptr ? Value() : row.x, row.series);
  });
  const auto best_settings = find_best(columns);
  const std::vector<Value>* best = nullptr;
  std::tuple<std::size_t, std::size_t, std::size_t, std::size_t> most;
  for (const auto& [values, cells] : seen) {
    std::size_t usual = 0, of_best = 0, size = 0;
    for (std::size_t k = 0; k < free.size(); ++k) {
      usual += values[k] == usual_value(free[k]->key) ? 1 : 0;
      of_best += best_settings && is_setting(*best_settings, free[k], values[k]) ? 1 : 0;
      if (free[k]->key == "size") size = rank_of("size", value_text(values[k]));
    }
    const std::tuple score(cells.size(), usual, of_best, size);
    if (best != nullptr && score <= most) continue;
    best = &values;
    most = score;
  }
  Held held;
  for (std::size_t k = 0; best != nullptr && k < free.size(); ++k) {
    held.emplace_back(free[k], (*best)[k]);
  }
  if (const auto frames = choose_frames(columns, chart)) held.push_back(*frames);
  return held;
}

std::vector<Line> lines_of(const Columns& columns, const Chart& chart) {
  std::map<std::string, std::map<Value, std::vector<double>>> found;
  for (const Row& row : rows_of(columns, chart)) found[row.series][row.x].push_back(row.y);
  std::vector<Line> lines;
  for (const std::string& name : series_of(chart)) {
    Line line{name, {}};
    for (const Value& x : chart.x->distinct) {
      if (const auto spread = spread_of(found[name][x])) line.at.emplace_back(x, *spread);
    }
    if (!line.at.empty()) lines.push_back(std::move(line));
  }
  return lines;
}

}  // namespace wedgesim::reports::page
