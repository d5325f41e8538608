#include "reports/page/statistics.h"

#include <cmath>

namespace wedgesim::reports::page {

std::optional<Spread> spread_of(std::vector<double> values) {
  if (values.empty()) return std::nullopt;
  const std::size_t count = values.size();
  return Spread{reports::spread_of(std::move(values)), count};
}

std::optional<double> log_slope(const std::vector<std::pair<double, double>>& points) {
  double n = 0.0, x_sum = 0.0, y_sum = 0.0, xx = 0.0, xy = 0.0;
  for (const auto& [x, y] : points) {
    if (x <= 0.0 || y <= 0.0) continue;
    const double u = std::log(x), v = std::log(y);
    n += 1.0;
    x_sum += u;
    y_sum += v;
    xx += u * u;
    xy += u * v;
  }
  const double spread = n * xx - x_sum * x_sum;
  if (n < 2.0 || spread <= 1e-9 * n * xx) return std::nullopt;
  return (n * xy - x_sum * y_sum) / spread;
}

}  // namespace wedgesim::reports::page
