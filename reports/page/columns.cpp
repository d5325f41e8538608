#include "reports/page/columns.h"

#include <algorithm>
#include <map>
#include <set>

#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

using Kind = Column::Kind;

bool is_nothing(const Value& value) { return std::holds_alternative<std::monostate>(value); }

void find_distinct(Column& column) {
  column.distinct.clear();
  for (const Value& value : column.values) {
    if (!is_nothing(value)) column.distinct.push_back(value);
  }
  const auto order = [&column](const Value& value) {
    const std::string* word = std::get_if<std::string>(&value);
    return std::tuple(word != nullptr, number_of(value).value_or(0.0),
                      word == nullptr ? 0 : rank_of(column.key, *word),
                      word == nullptr ? std::string() : *word);
  };
  std::ranges::sort(column.distinct,
                    [&](const Value& a, const Value& b) { return order(a) < order(b); });
  const auto rest = std::ranges::unique(column.distinct);
  column.distinct.erase(rest.begin(), rest.end());
}

std::map<std::string, const FrameRow*> frames_by_label(const Results& results) {
  std::map<std::string, const FrameRow*> frames;
  for (const FrameRow& frame : results.frames) frames[frame.label] = &frame;
  return frames;
}

// "640×427", and with its pixels: one column where width and height would be two.
void add_size(const FrameRow& frame, Values& values) {
  const auto width = number_of(find_value(frame.parameters, "width"));
  const auto height = number_of(find_value(frame.parameters, "height"));
  if (!width || !height) return;
  values["size"] = to_text(find_value(frame.parameters, "width")) + "×" +
                   to_text(find_value(frame.parameters, "height"));
  values["pixels"] = static_cast<std::int64_t>(*width * *height);
}

}  // namespace

bool Column::is_number() const {
  return !distinct.empty() && std::ranges::all_of(distinct, [](const Value& value) {
    return number_of(value).has_value();
  });
}

std::optional<double> Column::number(std::size_t point) const { return number_of(values[point]); }

double Column::range() const {
  const double low = number_of(distinct.front()).value_or(0.0);
  return low > 0.0 ? number_of(distinct.back()).value_or(0.0) / low : 1.0;
}

Columns::Columns(const Results& results) : results_(&results) {
  add_frames();
  add_measures();
  add_values(Kind::setting);
  add_values(Kind::metric);
  add_run_seconds();
  for (Column& column : columns_) find_distinct(column);
  std::vector<Column> derived;
  add_derived(*this, derived);
  for (Column& column : derived) {
    find_distinct(column);
    columns_.push_back(std::move(column));
  }
  find_axes();
}

bool Columns::done(std::size_t point) const {
  return results_->points[point].state == PointState::done;
}

Column& Columns::add(std::string key, Kind kind) {
  Name name = name_of(key);
  columns_.push_back({std::move(key),
                      std::move(name.label),
                      std::move(name.unit),
                      kind,
                      name.better,
                      std::vector<Value>(points()),
                      {}});
  return columns_.back();
}

void Columns::add_frames() {
  const auto frames = frames_by_label(*results_);
  std::vector<Values> rows(points());
  std::set<std::string> keys;
  for (std::size_t i = 0; i < points(); ++i) {
    const auto found = frames.find(results_->points[i].frame);
    if (found == frames.end()) continue;
    const FrameRow& frame = *found->second;
    rows[i] = frame.parameters;
    rows[i]["scene"] = frame.scene;
    if (frame.failure.empty()) rows[i]["wedges"] = frame.wedges;
    add_size(frame, rows[i]);
    for (const auto& [key, value] : rows[i]) keys.insert(key);
  }
  for (const std::string& key : keys) {
    Column& column = add(key, Kind::frame);
    for (std::size_t i = 0; i < points(); ++i) column.values[i] = find_value(rows[i], key);
  }
}

void Columns::add_measures() {
  Column& column = add("measure", Kind::setting);
  for (std::size_t i = 0; i < points(); ++i) column.values[i] = results_->points[i].measure;
}

void Columns::add_values(Kind kind) {
  const auto values_of = [&](const PointRow& point) -> const Values& {
    return kind == Kind::setting ? point.configuration : point.metrics;
  };
  std::map<std::string, std::size_t> index;
  for (std::size_t i = 0; i < points(); ++i) {
    for (const auto& [key, value] : values_of(results_->points[i])) {
      auto found = index.find(key);
      if (found == index.end()) {
        found = index.emplace(key, columns_.size()).first;
        add(key, kind);
      }
      columns_[found->second].values[i] = value;
    }
  }
}

// Timing, which differs from run to run: only where datapaths are told apart by what they cost.
void Columns::add_run_seconds() {
  std::set<Value> datapaths;
  for (const PointRow& point : results_->points) {
    datapaths.insert(find_value(point.configuration, "datapath"));
  }
  if (datapaths.size() < 2) return;
  Column& column = add("run_seconds", Kind::metric);
  for (std::size_t i = 0; i < points(); ++i) {
    if (done(i)) column.values[i] = results_->points[i].seconds;
  }
}

void Columns::find_axes() {
  const StudyHead& study = results_->study;
  const auto add_axis = [this](std::string_view key, Kind kind) {
    const Column* column = find(key);
    if (column == nullptr || column->kind != kind || !column->varies() || is_axis(column)) return;
    axes_.push_back(column);
  };
  add_axis("measure", Kind::setting);
  for (const std::string& key : study.axes) add_axis(key, Kind::setting);
  for (const std::string& key : study.by) {
    if (key == "scene") continue;
    const bool is_size = key == "width" || key == "height";
    add_axis(is_size ? "size" : key, Kind::frame);
  }
}

const Column* Columns::find(std::string_view key) const {
  const auto found = std::ranges::find(columns_, key, &Column::key);
  return found == columns_.end() ? nullptr : &*found;
}

const Column* Columns::number(std::string_view key) const {
  const Column* column = find(key);
  return column != nullptr && column->is_number() ? column : nullptr;
}

const Column* Columns::axis(std::string_view key) const {
  const Column* column = find(key);
  return is_axis(column) ? column : nullptr;
}

bool Columns::is_axis(const Column* column) const {
  return std::ranges::find(axes_, column) != axes_.end();
}

}  // namespace wedgesim::reports::page
