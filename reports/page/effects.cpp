#include "reports/page/effects.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <optional>

#include "reports/page/caption.h"
#include "reports/page/findings.h"
#include "reports/page/names.h"
#include "reports/page/statistics.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

/// Points that are alike in all but one axis.
using Twins = std::map<std::vector<Value>, std::map<Value, double>>;

using At = std::pair<const Column*, Value>;

Twins twins_of(const Columns& columns, const Column& metric, const Column& axis,
               const At& at = {}) {
  Twins twins;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    const auto value = metric.number(i);
    if (!columns.done(i) || !value) continue;
    if (at.first != nullptr && at.first->values[i] != at.second) continue;
    // The frame says all of the frame's parameters, unless one of them is what differs.
    std::vector<Value> rest;
    if (axis.kind == Column::Kind::setting) rest.emplace_back(columns.results().points[i].frame);
    for (const Column* other : columns.axes()) {
      if (other != &axis) rest.push_back(other->values[i]);
    }
    if (axis.kind == Column::Kind::frame) {
      for (const char* key : {"scene", "frame"}) {
        if (const Column* column = columns.find(key)) rest.push_back(column->values[i]);
      }
    }
    twins[rest][axis.values[i]] = *value;
  }
  return twins;
}

// "−3.1 % to +4.0 %"
std::string band_text(const Spread& ratio) {
  const auto signed_text = [](double r) {
    const std::string text = percent_text(r - 1.0);
    return text.starts_with("−") || text == "0.0 %" ? text : "+" + text;
  };
  return signed_text(ratio.low) + " to " + signed_text(ratio.high);
}

std::string times_text(double ratio) {
  return ratio < 2.0 ? fmt::format("{:.2f}", ratio) : number_text(ratio);
}

// What settings have an effect on: of varied widths not their bits, but what they cost in truth.
const Column* effects_metric(const Columns& columns) {
  const Column* metric = judging_metric(columns);
  return metric != nullptr && metric->key == "format_bits" ? columns.number("max_error") : metric;
}

std::optional<Spread> change(const Columns& columns, const char* metric, const Column& axis,
                             const Value& from, const Value& to, const At& at = {}) {
  const Column* column = columns.number(metric);
  if (column == nullptr) return std::nullopt;
  return spread_of(paired_ratios(columns, *column, axis, from, to, at));
}

// The tile size that culling is spoken of at: the best, if the study varies it.
At best_tile(const Columns& columns) {
  const auto best = find_best(columns);
  if (!best) return {};
  for (const auto& [column, value] : best->settings) {
    if (column->key == "block.tile") return {column, value};
  }
  return {};
}

std::string efficiency_text(const Columns& columns, const At& cull, const At& tile) {
  const Column* efficiency = columns.number("cull_efficiency");
  if (efficiency == nullptr) return "";
  std::vector<double> found;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    if (cull.first->values[i] != cull.second || !efficiency->number(i)) continue;
    if (tile.first == nullptr || tile.first->values[i] == tile.second) {
      found.push_back(*efficiency->number(i) / 100.0);
    }
  }
  const auto spread = spread_of(found);
  return spread ? fmt::format(" and skips {} of the visits that a perfect cull would",
                              percent_text(spread->median))
                : "";
}

std::optional<std::pair<double, std::string>> effect_of(const Columns& columns,
                                                        const Column& metric, const Column& axis) {
  std::map<Value, std::size_t> wins;
  std::size_t contests = 0;
  const bool more = metric.better == Better::more;
  for (const auto& [rest, values] : twins_of(columns, metric, axis)) {
    if (values.size() < 2) continue;
    const auto by_value = [](const auto& entry) { return entry.second; };
    const auto [low, high] = std::ranges::minmax_element(values, {}, by_value);
    if (low->second == high->second) continue;
    wins[more ? high->first : low->first] += 1;
    contests += 1;
  }
  if (wins.empty()) return std::nullopt;
  const Value best =
      std::ranges::max_element(wins, {}, [](const auto& entry) { return entry.second; })->first;
  std::optional<Spread> worst;
  Value worst_value;
  for (const Value& value : axis.distinct) {
    if (value == best) continue;
    const auto ratio = spread_of(paired_ratios(columns, metric, axis, best, value));
    if (!ratio) continue;
    const bool is_worse =
        !worst || (more ? ratio->median < worst->median : ratio->median > worst->median);
    if (!is_worse) continue;
    worst = ratio;
    worst_value = value;
  }
  if (!worst || worst->median <= 0.0) return std::nullopt;
  return std::pair(
      std::abs(std::log(worst->median)),
      fmt::format("Judged by {}, {} is best in {} of {} comparisons alike in all else; with {} it "
                  "is {} times as much (median; 5th to 95th percentile {} to {}).",
                  metric.label, setting_text(axis, best),
                  number_text(static_cast<double>(wins[best])),
                  number_text(static_cast<double>(contests)), value_text(worst_value),
                  times_text(worst->median), times_text(worst->low), times_text(worst->high)));
}

}  // namespace

std::vector<double> paired_ratios(const Columns& columns, const Column& metric, const Column& axis,
                                  const Value& from, const Value& to, const At& at) {
  std::vector<double> ratios;
  for (const auto& [rest, values] : twins_of(columns, metric, axis, at)) {
    const auto a = values.find(from), b = values.find(to);
    if (a == values.end() || b == values.end() || a->second == 0.0) continue;
    ratios.push_back(b->second / a->second);
  }
  return ratios;
}

// What single-pass changes, mode against mode and all else alike.
std::vector<std::string> mode_findings(const Columns& columns) {
  const Column* mode = columns.axis("block.mode");
  if (mode == nullptr) return {};
  const Value three(std::string("three-pass")), single(std::string("single-pass"));
  std::vector<std::string> parts;
  std::vector<std::size_t> pairs;  // a study may count more than it runs in time
  for (const auto& [metric, label] : {std::pair("cycles", "cycles"),
                                      {"z_reads", "z reads"},
                                      {"li_writes", "LI writes"},
                                      {"all_bytes", "all bytes"}}) {
    const auto ratio = change(columns, metric, *mode, three, single);
    if (!ratio) continue;
    pairs.push_back(ratio->count);
    parts.push_back(
        fmt::format("{} {} ({})", label, change_text(ratio->median), band_text(*ratio)));
  }
  if (parts.empty()) return {};
  const auto [fewest, most] = std::ranges::minmax(pairs);
  std::string count = number_text(static_cast<double>(fewest));
  if (most != fewest) count += " to " + number_text(static_cast<double>(most));
  return {
      fmt::format("Single-pass against three-pass: {}; medians, and 5th to 95th "
                  "percentiles, of {} pairs of points alike in all else.",
                  listed(parts), count)};
}

std::vector<std::string> culling_findings(const Columns& columns) {
  const Column* cull = columns.axis("block.cull");
  if (cull == nullptr) return {};
  const At tile = best_tile(columns);
  const Value none(std::string("none"));
  std::optional<Spread> least;
  Value best;
  for (const Value& value : cull->distinct) {
    const auto ratio =
        value == none ? std::nullopt : change(columns, "z_reads", *cull, none, value, tile);
    if (!ratio || (least && ratio->median >= least->median)) continue;
    least = ratio;
    best = value;
  }
  if (!least) return {};
  const std::string place = tile.first == nullptr
                                ? "Culling"
                                : fmt::format("At tile {}, culling", value_text(tile.second));
  return {
      fmt::format("{} by {} leaves {} of the z reads (median of {} pairs; 5th to 95th percentile "
                  "{} to {}){}.",
                  place, value_text(best), percent_text(least->median),
                  number_text(static_cast<double>(least->count)), percent_text(least->low),
                  percent_text(least->high), efficiency_text(columns, {cull, best}, tile))};
}

// Of each other axis, the best value against the worst.
std::vector<std::string> setting_findings(const Columns& columns) {
  const Column* metric = effects_metric(columns);
  std::vector<std::string> found;
  if (metric == nullptr) return found;
  std::vector<std::pair<double, std::string>> weighted;
  for (const Column* axis : columns.axes()) {
    if (axis->key == "block.mode" || axis->key == "block.cull") continue;
    if (axis->key == "measure" || axis->key == "size" || axis->key == "datapath") continue;
    if (auto effect = effect_of(columns, *metric, *axis)) weighted.push_back(*std::move(effect));
  }
  std::ranges::sort(weighted, std::greater());
  for (auto& [weight, text] : weighted) found.push_back(std::move(text));
  return found;
}

}  // namespace wedgesim::reports::page
