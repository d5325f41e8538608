#include "reports/stress/stress_picture.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "reports/sheet.h"
#include "reports/stress/replay.h"

namespace wedgesim::reports::stress {
namespace {

constexpr int kVisible = 256;        // edge of a panel that is visible, pixels
constexpr int kLong = 8;             // frames this many times longer than high, or higher than long
constexpr double kMostWithin = 0.5;  // saturation at the bar

Panel li_panel(const Measurement& measurement, const std::vector<double>& li) {
  Panel panel;
  for (std::size_t i = 0; i < li.size(); ++i) {
    panel.push_back(std::isnan(measurement.judge[i]) ? kSky : grey_of(li[i]));
  }
  return panel;
}

bool is_beyond(const Measurement& measurement, Arithmetic arithmetic, std::size_t pixel) {
  return !(excess_at(measurement, arithmetic, pixel) <= tolerance_of(arithmetic));
}

Panel difference_panel(const Measurement& measurement, Arithmetic arithmetic) {
  const std::vector<double>& li = measurement.errors[static_cast<std::size_t>(arithmetic)].li;
  Panel panel;
  for (std::size_t i = 0; i < li.size(); ++i) {
    const double error = li[i] - measurement.judge[i];
    const double bar = tolerance_of(arithmetic) + measurement.sensitivities[i];
    const bool beyond = is_beyond(measurement, arithmetic, i);
    const double saturation = beyond ? 1.0 : kMostWithin * std::min(std::fabs(error) / bar, 1.0);
    panel.push_back(std::isnan(measurement.judge[i]) ? kSky : difference_colour(error, saturation));
  }
  return panel;
}

}  // namespace

int visible_scale(const Measurement& measurement) {
  return std::max(1, kVisible / std::max(measurement.width, measurement.height));
}

Image picture_of(const Measurement& measurement, std::span<const Arithmetic> arithmetics,
                 int scale) {
  const int panels = 3 * static_cast<int>(arithmetics.size());
  int columns = 3;
  if (measurement.width >= kLong * measurement.height) columns = 1;
  if (measurement.height >= kLong * measurement.width) columns = panels;
  Sheet sheet(measurement.width, measurement.height, columns, panels / columns, scale);
  for (const Arithmetic arithmetic : arithmetics) {
    std::vector<bool> beyond;
    for (std::size_t i = 0; i < measurement.judge.size(); ++i) {
      beyond.push_back(is_beyond(measurement, arithmetic, i));
    }
    sheet.add(li_panel(measurement, measurement.judge));
    const auto& errors = measurement.errors[static_cast<std::size_t>(arithmetic)];
    sheet.add(li_panel(measurement, errors.li));
    sheet.add(difference_panel(measurement, arithmetic), beyond);
  }
  return sheet.take();
}

}  // namespace wedgesim::reports::stress
