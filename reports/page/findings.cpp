#include "reports/page/findings.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>

#include "reports/page/caption.h"
#include "reports/page/names.h"
#include "reports/runner/value.h"

namespace wedgesim::reports::page {
namespace {

// What a slope is stated of: less may come from what else differs between frames.
constexpr double kLeastRange = 10.0;
constexpr double kLeastEdgeRange = 100.0;

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

/// Finds what can be said, each kind at most once.
class Finder {
 public:
  explicit Finder(const Columns& columns) : columns_(columns), metric_(effects_metric(columns)) {}

  std::vector<std::string> find(std::size_t most) {
    slopes();
    bottleneck();
    modes();
    widths();
    culling();
    axes_by_weight();
    floor();
    if (found_.size() > most) found_.resize(most);
    return found_;
  }

 private:
  const Column* axis(std::string_view key) const {
    const Column* column = columns_.find(key);
    return columns_.is_axis(column) ? column : nullptr;
  }

  std::optional<Spread> change(const char* metric, const Column& axis, const Value& from,
                               const Value& to, const At& at = {}) const {
    const Column* column = columns_.number(metric);
    if (column == nullptr) return std::nullopt;
    return spread_of(paired_ratios(columns_, *column, axis, from, to, at));
  }

  // How cost grows with the frame's size and edges.
  void slopes() {
    const Column* cost = columns_.number("cycles");
    if (cost == nullptr) cost = columns_.number("accesses");
    if (cost == nullptr) return;
    for (const char* key : {"pixels", "wedges"}) {
      const Column* x = columns_.number(key);
      if (x == nullptr || x->range() < (x->key == "wedges" ? kLeastEdgeRange : kLeastRange)) {
        continue;
      }
      if (x->key == "pixels" && axis("size") == nullptr) continue;
      std::vector<std::pair<double, double>> points;
      for (std::size_t i = 0; i < columns_.points(); ++i) {
        if (x->number(i) && cost->number(i)) points.emplace_back(*x->number(i), *cost->number(i));
      }
      const auto slope = log_slope(points);
      if (!slope) continue;
      found_.push_back(
          fmt::format("{} grow with the {} to the power {:.2f}, from {} to {} of them: {}.",
                      columns_.number("cycles") == cost ? "Cycles" : "Accesses", x->label, *slope,
                      value_text(x->distinct.front()), value_text(x->distinct.back()),
                      *slope > 1.05   ? "more than in proportion"
                      : *slope < 0.95 ? "less than in proportion"
                                      : "in proportion"));
    }
  }

  void bottleneck() {
    const Column* unit = columns_.find("bottleneck");
    if (unit == nullptr || unit->distinct.empty()) return;
    std::map<std::string, std::size_t> times;
    std::size_t all = 0;
    for (const Value& value : unit->values) {
      if (std::holds_alternative<std::monostate>(value)) continue;
      times[value_text(value)] += 1;
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
    found_.push_back(fmt::format("The bottleneck is {}.", listed(parts)));
  }

  // What single-pass changes, mode against mode and all else alike.
  void modes() {
    const Column* mode = axis("block.mode");
    if (mode == nullptr) return;
    const Value three(std::string("three-pass")), single(std::string("single-pass"));
    std::vector<std::string> parts;
    std::size_t pairs = 0;
    for (const auto& [metric, label] : {std::pair("cycles", "cycles"),
                                        {"z_reads", "z reads"},
                                        {"li_writes", "LI writes"},
                                        {"all_bytes", "all bytes"}}) {
      const auto ratio = change(metric, *mode, three, single);
      if (!ratio) continue;
      pairs = ratio->count;
      parts.push_back(
          fmt::format("{} {} ({})", label, change_text(ratio->median), band_text(*ratio)));
    }
    if (parts.empty()) return;
    found_.push_back(
        fmt::format("Single-pass against three-pass: {}; medians, and 5th to 95th "
                    "percentiles, of {} pairs of points alike in all else.",
                    listed(parts), number_text(static_cast<double>(pairs))));
  }

  // The narrowest width of each format with every pixel within its tolerance.
  void widths() {
    const Column* wrong = columns_.number("mismatched");
    if (wrong == nullptr || !wrong->varies()) return;
    std::vector<std::string> parts;
    for (const Column* format : columns_.axes()) {
      if (!format->key.starts_with("formats.") || !format->is_number()) continue;
      std::map<Value, double> worst;
      for (std::size_t i = 0; i < columns_.points(); ++i) {
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
    if (!parts.empty()) found_.push_back(capital(fmt::format("{}", fmt::join(parts, "; "))) + ".");
  }

  // The tile size that culling is spoken of at: the best, if the study varies it.
  At best_tile() const {
    const auto best = find_best(columns_);
    if (!best) return {};
    for (const auto& [column, value] : best->settings) {
      if (column->key == "block.tile") return {column, value};
    }
    return {};
  }

  void culling() {
    const Column* cull = axis("block.cull");
    if (cull == nullptr) return;
    const At tile = best_tile();
    const Value none(std::string("none"));
    std::optional<Spread> least;
    Value best;
    for (const Value& value : cull->distinct) {
      const auto ratio = value == none ? std::nullopt : change("z_reads", *cull, none, value, tile);
      if (!ratio || (least && ratio->median >= least->median)) continue;
      least = ratio;
      best = value;
    }
    if (!least) return;
    const std::string place = tile.first == nullptr
                                  ? "Culling"
                                  : fmt::format("At tile {}, culling", value_text(tile.second));
    found_.push_back(
        fmt::format("{} by {} leaves {} of the z reads (median of {} pairs; 5th to 95th percentile "
                    "{} to {}){}.",
                    place, value_text(best), percent_text(least->median),
                    number_text(static_cast<double>(least->count)), percent_text(least->low),
                    percent_text(least->high), efficiency_text({cull, best}, tile)));
  }

  std::string efficiency_text(const At& cull, const At& tile) const {
    const Column* efficiency = columns_.number("cull_efficiency");
    if (efficiency == nullptr) return "";
    std::vector<double> found;
    for (std::size_t i = 0; i < columns_.points(); ++i) {
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

  // Of each other axis, the best value against the worst.
  void axes_by_weight() {
    if (metric_ == nullptr) return;
    std::vector<std::pair<double, std::string>> weighted;
    for (const Column* axis : columns_.axes()) {
      if (axis->key == "block.mode" || axis->key == "block.cull") continue;
      if (axis->key == "measure" || axis->key == "size") continue;
      if (auto effect = effect_of(*axis)) weighted.push_back(*std::move(effect));
    }
    std::ranges::sort(weighted, std::greater());
    for (auto& [weight, text] : weighted) found_.push_back(std::move(text));
  }

  std::optional<std::pair<double, std::string>> effect_of(const Column& axis) const {
    std::map<Value, std::size_t> wins;
    std::size_t contests = 0;
    const bool more = metric_->better == Better::more;
    for (const auto& [rest, values] : twins_of(columns_, *metric_, axis)) {
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
      const auto ratio = spread_of(paired_ratios(columns_, *metric_, axis, best, value));
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
        fmt::format(
            "Judged by {}, {} is best in {} of {} comparisons alike in all else; with {} it "
            "is {} times as much (median; 5th to 95th percentile {} to {}).",
            metric_->label, setting_text(axis, best), number_text(static_cast<double>(wins[best])),
            number_text(static_cast<double>(contests)), value_text(worst_value),
            times_text(worst->median), times_text(worst->low), times_text(worst->high)));
  }

  void floor() {
    const Column* over = columns_.number("over_floor");
    if (over == nullptr) return;
    std::map<std::string, double> least;
    for (std::size_t i = 0; i < columns_.points(); ++i) {
      const auto value = over->number(i);
      if (!value) continue;
      const std::string& frame = columns_.results().points[i].frame;
      const auto found = least.emplace(frame, *value).first;
      found->second = std::min(found->second, *value);
    }
    std::vector<double> values;
    for (const auto& [frame, value] : least) values.push_back(value);
    const auto spread = spread_of(values);
    if (!spread) return;
    found_.push_back(
        fmt::format("Even the best configuration of each frame makes {} times the "
                    "accesses of the floor (median; {} to {} over {} frames).",
                    number_text(spread->median), number_text(spread->low),
                    number_text(spread->high), spread->count));
  }

  const Columns& columns_;
  const Column* metric_;
  std::vector<std::string> found_;
};

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

std::vector<std::string> find_findings(const Columns& columns, std::size_t most) {
  return Finder(columns).find(most);
}

}  // namespace wedgesim::reports::page
