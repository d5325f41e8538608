#include "reports/claims/claims.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <optional>
#include <set>

#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

/// Finds points by frame, measure, and those keys that claims speak of.
class PointIndex {
 public:
  PointIndex(const ClaimFile& file, const Results& results) {
    const auto add = [this](const auto& values) {
      for (const auto& [key, value] : values) {
        if (key != "scene") keys_.insert(key);
      }
    };
    add(file.defaults);
    for (const Claim& claim : file.claims) {
      for (const Measurement& measurement : claim.measured) {
        add(measurement.where);
        add(measurement.from);
        add(measurement.to);
        if (!measurement.over.empty()) keys_.insert(measurement.over);
      }
    }
    for (const PointRow& point : results.points) {
      if (point.state != PointState::done) continue;
      points_.emplace(name(point.frame, point.measure, point.configuration), &point);
      for (const std::string& key : keys_) {
        values_[key].insert(find_value(point.configuration, key));
        defaults_.emplace(key, find_value(point.configuration, key));
      }
    }
    for (const auto& [key, value] : file.defaults) defaults_[key] = value;
  }

  /// Null if there is none.
  const PointRow* find(const std::string& frame, const std::string& measure,
                       const Values& settings) const {
    Values values = defaults_;
    for (const auto& [key, value] : settings) values[key] = value;
    const auto found = points_.find(name(frame, measure, values));
    return found == points_.end() ? nullptr : found->second;
  }
  /// All values of a key in the study.
  const std::set<Value>& values(const std::string& key) const { return values_.at(key); }
  bool has(const std::string& key) const { return values_.contains(key); }

 private:
  std::string name(const std::string& frame, const std::string& measure,
                   const Values& configuration) const {
    std::string name = frame + '\n' + measure;
    for (const std::string& key : keys_) {
      name += '\n' + to_text(find_value(configuration, key));
    }
    return name;
  }

  std::set<std::string> keys_;
  Values defaults_;  // of keys without a default of their own, what the study's first point has
  std::map<std::string, std::set<Value>> values_;
  std::map<std::string, const PointRow*> points_;
};

std::vector<Values> combinations(const std::map<std::string, std::vector<Value>>& where) {
  std::vector<Values> all{{}};
  for (const auto& [key, values] : where) {
    std::vector<Values> more;
    for (const Values& begun : all) {
      for (const Value& value : values) {
        more.push_back(begun);
        more.back()[key] = value;
      }
    }
    all = std::move(more);
  }
  return all;
}

Values merged(Values settings, const Values& more) {
  for (const auto& [key, value] : more) settings[key] = value;
  return settings;
}

// A claim about methods may name the scene of either side; else both are of the frame at hand.
const PointRow* find_point(const PointIndex& points, const Measurement& measurement,
                           const std::string& frame, Values settings) {
  const auto scene = settings.find("scene");
  if (scene == settings.end()) return points.find(frame, measurement.measure, settings);
  const std::string named = to_text(scene->second);
  settings.erase(scene);
  return points.find(named, measurement.measure, settings);
}

// Of a frame and a combination; nothing if the study lacks a point, or nothing is there to divide.
std::optional<double> value_of(const Measurement& measurement, const PointIndex& points,
                               const std::string& frame, const Values& where) {
  const PointRow* to = find_point(points, measurement, frame, merged(where, measurement.to));
  if (to == nullptr) return std::nullopt;
  if (measurement.kind == ClaimKind::value) return measurement.metric.of(*to);
  const PointRow* from = find_point(points, measurement, frame, merged(where, measurement.from));
  if (from == nullptr) return std::nullopt;
  const std::optional<double> a = measurement.of.of(*from);
  const std::optional<double> b = measurement.metric.of(*to);
  if (!a || !b || *a == 0.0 || (measurement.kind == ClaimKind::ratio && *b == 0.0)) {
    return std::nullopt;
  }
  switch (measurement.kind) {
    case ClaimKind::saved:
      return 100.0 * (1.0 - *b / *a);
    case ClaimKind::more:
      return 100.0 * (*b / *a - 1.0);
    case ClaimKind::ratio:
      return *a / *b;
    case ClaimKind::share:
      return 100.0 * *b / *a;
    case ClaimKind::value:
    case ClaimKind::best:
      break;
  }
  return std::nullopt;
}

// The value of the key `over` with the least metric.
std::optional<double> best_of(const Measurement& measurement, const PointIndex& points,
                              const std::string& frame, const Values& where) {
  std::optional<double> best;
  double least = 0.0;
  if (!points.has(measurement.over)) return best;
  for (const Value& value : points.values(measurement.over)) {
    Values settings = merged(where, measurement.to);
    settings[measurement.over] = value;
    const PointRow* point = points.find(frame, measurement.measure, settings);
    const std::optional<double> sum = point ? measurement.metric.of(*point) : std::nullopt;
    if (!sum || (best && *sum >= least)) continue;
    least = *sum;
    best = number_of(value);
  }
  return best;
}

constexpr double kOften = 0.25;  // of the values in the band: worth to be said

Measured summed_up(const Claim& claim, const std::vector<double>& values) {
  Measured measured;
  measured.count = values.size();
  if (values.empty()) return measured;
  measured.spread = spread_of(values);
  measured.most = std::ranges::max(values);
  const auto within = std::ranges::count_if(
      values, [&claim](double value) { return value >= claim.low && value <= claim.high; });
  measured.within = static_cast<double>(within) / static_cast<double>(values.size());
  return measured;
}

std::map<std::string, Measured> measure(const Claim& claim, const Measurement& measurement,
                                        const PointIndex& points, const Results& results) {
  std::map<std::string, std::vector<double>> values;
  for (const FrameRow& frame : results.frames) {
    const bool wanted =
        claim.scenes.empty() || std::ranges::find(claim.scenes, frame.scene) != claim.scenes.end();
    if (!wanted) continue;
    const std::string kind = to_text(find_value(frame.parameters, "kind"));
    for (const Values& where : combinations(measurement.where)) {
      const auto value = measurement.kind == ClaimKind::best
                             ? best_of(measurement, points, frame.label, where)
                             : value_of(measurement, points, frame.label, where);
      if (value) values[kind].push_back(*value);
    }
  }
  std::map<std::string, Measured> measured;
  for (const auto& [kind, all] : values) measured[kind] = summed_up(claim, all);
  return measured;
}

bool in_band(const Claim& claim, const Measured& measured) {
  if (measured.count == 0) return false;
  const double value = claim.most ? measured.most : measured.spread.median;
  return value >= claim.low && value <= claim.high;
}

// The other conventions, and the other wedges where there are such, for which `holds` is true.
template <typename Holds>
std::string conventions(const ClaimResult& result, Holds holds) {
  std::string list;
  for (std::size_t i = 0; i < result.measured.size(); ++i) {
    for (const auto& [kind, measured] : result.measured[i]) {
      if (!holds(measured)) continue;
      list += fmt::format("{}{}", list.empty() ? "" : "; ", result.claim->measured[i].definition);
      if (!kind.empty()) list += fmt::format(" ({} wedges)", kind);
    }
  }
  return list;
}

void judge(ClaimResult& result) {
  const Claim& claim = *result.claim;
  const Measured literal = result.literal();
  if (literal.count == 0) {
    result.because = claim.needs.empty() ? "the study lacks its points" : "needs " + claim.needs;
    return;
  }
  if (in_band(claim, literal)) {
    result.verdict = Verdict::reproduced;
    return;
  }
  const std::string held =
      conventions(result, [&](const Measured& measured) { return in_band(claim, measured); });
  const std::string often =
      conventions(result, [&](const Measured& measured) { return measured.within >= kOften; });
  result.verdict = Verdict::depends;
  if (!held.empty()) {
    result.because = "holds if: " + held;
  } else if (!often.empty()) {
    result.because = "holds for many values of: " + often;
  } else if (literal.spread.low <= claim.high && literal.spread.high >= claim.low) {
    result.because = "scene and view";
  } else {
    result.verdict = Verdict::not_reproduced;
  }
}

}  // namespace

std::string_view spelling(Verdict verdict) {
  switch (verdict) {
    case Verdict::reproduced:
      return "reproduced";
    case Verdict::depends:
      return "depends";
    case Verdict::not_reproduced:
      return "not reproduced";
    case Verdict::not_measured:
      return "not measured";
  }
  return "";
}

Measured ClaimResult::literal() const {
  if (measured.empty()) return {};
  const auto found = measured.front().find(claim->wedges);
  return found == measured.front().end() ? Measured{} : found->second;
}

std::vector<ClaimResult> judge_claims(const ClaimFile& file, const Results& results) {
  const PointIndex points(file, results);
  std::vector<ClaimResult> judged;
  for (const Claim& claim : file.claims) {
    ClaimResult result;
    result.claim = &claim;
    for (const Measurement& measurement : claim.measured) {
      result.measured.push_back(measure(claim, measurement, points, results));
    }
    judge(result);
    judged.push_back(std::move(result));
  }
  return judged;
}

}  // namespace wedgesim::reports
