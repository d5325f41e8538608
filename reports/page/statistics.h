#pragma once

#include <optional>
#include <utility>
#include <vector>

#include "reports/runner/spread.h"

namespace wedgesim::reports::page {

/// Median and percentiles, and of how many values.
struct Spread : reports::Spread {
  std::size_t count = 0;
};

/// Nothing for no values.
std::optional<Spread> spread_of(std::vector<double> values);

/// The slope of the straight line nearest to log y over log x; nothing for fewer than two x.
/// \param points  x, y; those not above 0 are left out
std::optional<double> log_slope(const std::vector<std::pair<double, double>>& points);

}  // namespace wedgesim::reports::page
