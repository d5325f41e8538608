#include "tests/reports/stress/sample.h"

#include <cmath>

namespace wedgesim::reports::stress::tests {
namespace {

Errors& errors_of(Measurement& measurement, Arithmetic arithmetic) {
  return measurement.errors[static_cast<std::size_t>(arithmetic)];
}

// One or two pixels, off by `error`.
void break_pixels(Measurement& measurement, Arithmetic arithmetic, double error,
                  const std::vector<std::size_t>& pixels) {
  Errors& errors = errors_of(measurement, arithmetic);
  for (const std::size_t pixel : pixels) errors.li[pixel] += error;
  errors.max_error = errors.max_excess = std::fabs(error);
  errors.rms = errors.rms_penumbra = std::fabs(error) / 2.0;
  errors.beyond = errors.unflagged = errors.unforeseen = pixels.size();
  errors.off = std::fabs(error) > 1.0 / 255.0 ? pixels.size() : 0;
  errors.holds = false;
}

FamilyResult all_hold(const Family& family) {
  FamilyResult result;
  result.family = &family;
  for (std::size_t i = 0; i < family.levels.size(); ++i) {
    result.levels.emplace_back(2, sample_measurement());
    for (Measurement& m : result.levels.back()) {
      m.condition = 2.0 * std::pow(10.0, static_cast<double>(i));
    }
  }
  return result;
}

}  // namespace

Measurement sample_measurement() {
  Measurement measurement;
  measurement.width = 4;
  measurement.height = 3;
  measurement.wedges = 8;
  measurement.judged = 12;
  measurement.in_penumbra = 12;
  measurement.judge.assign(12, 0.5);
  measurement.sensitivities.assign(12, 0.0);
  double time = 20e-9;
  for (const Arithmetic a : kArithmetics) {
    Errors& errors = errors_of(measurement, a);
    errors.li = measurement.judge;
    errors.rms = a == Arithmetic::fixed ? 1e-4 : 1e-10;
    errors.holds = true;
    if (a == Arithmetic::renderer) continue;
    errors.visits = 100;
    errors.seconds = 100.0 * time;
    time *= 2.0;
  }
  return measurement;
}

std::vector<FamilyResult> sample_results() {
  static const std::vector<double> levels{1.0, 1e-3, 1e-4, 0.0};
  static const Family steady{"steady", "a <b>number</b> & more", "rad", levels, {1e-4, 1e-4},
                             nullptr};
  static const Family brittle{"brittle",    "length</script><script>window.broken = 1</script>",
                              "",           levels,
                              {1e-4, 1e-4}, nullptr,
                              true};
  std::vector<FamilyResult> results{all_hold(steady), all_hold(brittle)};
  auto& broken = results.back().levels;
  for (const std::size_t level : {std::size_t{1}, std::size_t{2}}) {
    break_pixels(broken[level][1], Arithmetic::float32, 0.25, {5});
  }
  Measurement& flagged = broken[2][0];
  break_pixels(flagged, Arithmetic::double_precision, -0.001, {0, 1});
  errors_of(flagged, Arithmetic::double_precision).unflagged = 1;
  errors_of(flagged, Arithmetic::double_precision).unforeseen = 1;
  flagged.flagged[static_cast<std::size_t>(Arithmetic::double_precision)] = {{7, "too <thin>"}};
  for (Measurement& refused : broken[3]) {
    refused = {};
    refused.refused = "<i>no room</i>";
  }
  return results;
}

}  // namespace wedgesim::reports::stress::tests
