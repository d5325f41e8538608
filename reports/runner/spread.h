#pragma once

#include <optional>
#include <string>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports {

/// What values over frames are shown as: one frame decides nothing.
struct Spread {
  double low = 0.0, median = 0.0, high = 0.0;  // 5th, 50th, 95th percentile
};

/// The value that a fraction of the values lies below, linear between neighbours.
/// \param sorted    at least one
/// \param fraction  0 to 1
double quantile(const std::vector<double>& sorted, double fraction);

/// \param values  at least one, in any order
Spread spread_of(std::vector<double> values);

/// Points that differ in their frame alone.
struct PointGroup {
  std::vector<Value> by;                // of StudyHead::by
  Values configuration;                 // of all of them
  std::vector<const PointRow*> points;  // those done, in the study's order

  /// Of a metric that is a number everywhere; nothing without points that have it.
  std::optional<Spread> spread(std::string_view metric) const;
};

/// The points of a study that are done, grouped by StudyHead::by and by configuration.
/// \param results  outlives the groups
std::vector<PointGroup> groups_of(const Results& results);

/// Of a frame: its scene, its wedges, or a parameter.
Value frame_value(const FrameRow& frame, const std::string& key);

}  // namespace wedgesim::reports
