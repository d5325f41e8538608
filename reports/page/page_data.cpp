#include "reports/page/page_data.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

#include "reports/page/html.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

// Seven digits: the files beside the page hold all of them.
Json number_json(const Value& value) {
  const double* real = std::get_if<double>(&value);
  if (real == nullptr || !std::isfinite(*real) || *real == 0.0) return to_json(value);
  const double scale = std::pow(10.0, 6.0 - std::floor(std::log10(std::abs(*real))));
  if (!std::isfinite(scale) || scale == 0.0) return *real;
  return std::round(*real * scale) / scale;
}

// {"all": v}, {"words": [...], "at": [...]} or {"values": [...]}
Json values_json(const std::vector<Value>& values) {
  const bool same = std::ranges::all_of(
      values, [&values](const Value& value) { return value == values.front(); });
  if (same) return {{"all", values.empty() ? Json() : number_json(values.front())}};
  const bool words = std::ranges::any_of(
      values, [](const Value& value) { return std::holds_alternative<std::string>(value); });
  Json list = Json::array();
  if (!words) {
    for (const Value& value : values) list.push_back(number_json(value));
    return {{"values", std::move(list)}};
  }
  std::map<Value, std::size_t> places;
  Json distinct = Json::array();
  for (const Value& value : values) {
    const auto [place, is_new] = places.emplace(value, places.size());
    if (is_new) distinct.push_back(to_json(value));
    list.push_back(place->second);
  }
  return {{"words", std::move(distinct)}, {"at", std::move(list)}};
}

Json list_json(const std::vector<Value>& values) {
  Json list = Json::array();
  for (const Value& value : values) list.push_back(to_json(value));
  return list;
}

std::string kind_text(Column::Kind kind) {
  if (kind == Column::Kind::frame) return "frame";
  return kind == Column::Kind::setting ? "setting" : "metric";
}

Json column_json(const Column& column, const std::string& kind) {
  Json json{{"key", column.key}, {"label", column.label}, {"unit", column.unit}, {"kind", kind}};
  json.update(values_json(column.values));
  return json;
}

std::string_view word_of(PointState state) {
  switch (state) {
    case PointState::done:
      return "done";
    case PointState::failed:
      return "failed";
    case PointState::crashed:
      return "crashed";
    case PointState::overtime:
      return "overtime";
  }
  return "";
}

// What points are named by, and how they ended.
void add_identity(const Columns& columns, Json& list) {
  Column frame{"frame_label", "frame", "", Column::Kind::frame, Better::neither, {}, {}};
  Column state{"state", "state", "", Column::Kind::frame, Better::neither, {}, {}};
  Column message{"message", "message", "", Column::Kind::frame, Better::neither, {}, {}};
  Column key{"key", "key", "", Column::Kind::frame, Better::neither, {}, {}};
  for (const PointRow& point : columns.results().points) {
    frame.values.emplace_back(point.frame);
    state.values.emplace_back(std::string(word_of(point.state)));
    message.values.emplace_back(point.message);
    key.values.emplace_back(point.key.substr(0, 12));  // enough to find it in the files
  }
  for (const Column* column : {&frame, &state, &message, &key}) {
    list.push_back(column_json(*column, "point"));
  }
}

// Columns of the table: axes, then other settings that differ, then the study's metrics.
Json table_json(const Columns& columns) {
  std::vector<std::string> keys{"frame_label"};
  for (const Column* axis : columns.axes()) keys.push_back(axis->key);
  constexpr std::size_t kMostSettings = 12;
  for (const Column& column : columns.all()) {
    if (keys.size() > kMostSettings) break;
    if (column.kind != Column::Kind::setting || !column.varies()) continue;
    if (!columns.is_axis(&column)) keys.push_back(column.key);
  }
  const auto add = [&](const std::string& key) {
    if (columns.find(key) == nullptr || std::ranges::find(keys, key) != keys.end()) return;
    keys.push_back(key);
  };
  for (const std::string& key : columns.results().study.metrics) add(key);
  for (const char* key : {"accesses", "all_bytes", "over_floor", "cull_efficiency", "cycles",
                          "frames_per_second", "mismatched"}) {
    add(key);
  }
  keys.emplace_back("state");
  return keys;
}

// Metrics that the table or a chart shows.
std::set<std::string> shown_keys(const Json& table, const std::vector<Chart>& charts) {
  std::set<std::string> keys(table.begin(), table.end());
  for (const Chart& chart : charts) {
    for (const Column* column : {chart.x, chart.series, chart.per}) {
      if (column != nullptr) keys.insert(column->key);
    }
    for (const Measure& measure : chart.measures) keys.insert(measure.column->key);
  }
  return keys;
}

Json chart_json(const Chart& chart) {
  Json measures = Json::array();
  for (const Measure& measure : chart.measures) {
    measures.push_back({{"key", measure.column->key}, {"name", measure.name}, {"at", measure.at}});
  }
  Json held = Json::array();
  for (const auto& [column, value] : chart.held) held.push_back({column->key, to_json(value)});
  const auto key = [](const Column* column) {
    return column == nullptr ? Json() : Json(column->key);
  };
  return {{"id", chart.id},
          {"x", key(chart.x)},
          {"series", key(chart.series)},
          {"per", key(chart.per)},
          {"names", series_of(chart)},
          {"values", chart.series == nullptr ? Json() : list_json(chart.series->distinct)},
          {"measures", std::move(measures)},
          {"held", std::move(held)},
          {"spec", chart.spec}};
}

// Equal pictures are stored once.
Json maps_json(const std::vector<HeatMap>& maps, const std::vector<FramePicture>& pictures) {
  Json images = Json::array(), list = Json::array();
  std::map<std::string, std::size_t> places;
  for (const HeatMap& map : maps) {
    const auto [place, is_new] = places.emplace(map.png, places.size());
    if (is_new) images.push_back(base64(map.png));
    list.push_back({{"frame", map.frame},
                    {"mode", map.mode},
                    {"tile", map.tile},
                    {"kind", map.kind},
                    {"image", place->second},
                    {"maximum", map.maximum},
                    {"total", map.total},
                    {"file", map.file}});
  }
  Json frames = Json::object();
  for (const FramePicture& picture : pictures) frames[picture.frame] = base64(picture.png);
  return {{"images", std::move(images)}, {"list", std::move(list)}, {"frames", std::move(frames)}};
}

}  // namespace

Json page_data(const Page& page, const Columns& columns, const std::vector<Chart>& charts) {
  Json list = Json::array();
  add_identity(columns, list);
  const Json table = table_json(columns);
  const bool whole = columns.points() <= kMostWholePoints;
  const std::set<std::string> shown = shown_keys(table, charts);
  for (const Column& column : columns.all()) {
    if (!whole && column.kind == Column::Kind::metric && !shown.contains(column.key)) continue;
    list.push_back(column_json(column, kind_text(column.kind)));
    if (column.key != "scene" && !columns.is_axis(&column)) continue;
    list.back()["distinct"] = list_json(column.distinct);
  }
  Json axes = Json::array();
  for (const Column* axis : columns.axes()) axes.push_back(axis->key);
  Json drawn = Json::array();
  for (const Chart& chart : charts) drawn.push_back(chart_json(chart));
  return {{"name", page.results.study.name},
          {"whole", whole},
          {"points", columns.points()},
          {"columns", std::move(list)},
          {"axes", std::move(axes)},
          {"table", table},
          {"config", chart_config()},
          {"charts", std::move(drawn)},
          {"maps", maps_json(page.maps, page.pictures)}};
}

}  // namespace wedgesim::reports::page
