#include "reports/stress/levels.h"

#include <algorithm>
#include <utility>

namespace wedgesim::reports::stress {

Errors worst_of(const std::vector<Measurement>& seeds, Arithmetic arithmetic) {
  Errors worst;
  worst.holds = true;
  for (const Measurement& m : seeds) {
    if (m.refused) continue;
    const Errors& e = m.errors[static_cast<std::size_t>(arithmetic)];
    worst.max_error = std::max(worst.max_error, e.max_error);
    worst.max_excess = std::max(worst.max_excess, e.max_excess);
    worst.rms = std::max(worst.rms, e.rms);
    worst.rms_penumbra = std::max(worst.rms_penumbra, e.rms_penumbra);
    if (e.jump && (!worst.jump || worst.jump->excess < e.jump->excess)) worst.jump = e.jump;
    worst.off += e.off;
    worst.beyond += e.beyond;
    worst.specks += e.specks;
    worst.leaks += e.leaks;
    worst.signs += e.signs;
    worst.wrong_signs += e.wrong_signs;
    worst.not_finite += e.not_finite;
    worst.saturated += e.saturated;
    worst.overflowed += e.overflowed;
    worst.unflagged += e.unflagged;
    worst.unforeseen += e.unforeseen;
    worst.visits += e.visits;
    worst.seconds += e.seconds;
    worst.holds = worst.holds && e.holds;
  }
  return worst;
}

double condition_of(const std::vector<Measurement>& seeds) {
  double condition = 1.0;
  for (const Measurement& m : seeds) condition = std::max(condition, m.condition);
  return condition;
}

double median_of(std::vector<double> values) {
  const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
  std::ranges::nth_element(values, middle);
  return *middle;
}

namespace {

template <typename SecondsOf>
std::optional<double> median_nanoseconds(const FamilyResult& result, Arithmetic visitor,
                                         const SecondsOf& seconds_of) {
  std::vector<double> times;
  for (const auto& level : result.levels) {
    for (const Measurement& m : level) {
      const std::uint64_t visits = m.errors[static_cast<std::size_t>(visitor)].visits;
      if (visits > 0) times.push_back(1e9 * seconds_of(m) / static_cast<double>(visits));
    }
  }
  if (times.empty()) return {};
  return median_of(std::move(times));
}

}  // namespace

std::optional<double> nanoseconds_of(const FamilyResult& result, Arithmetic arithmetic) {
  return median_nanoseconds(result, arithmetic, [arithmetic](const Measurement& m) {
    return m.errors[static_cast<std::size_t>(arithmetic)].seconds;
  });
}

std::optional<double> judge_nanoseconds_of(const FamilyResult& result) {
  return median_nanoseconds(result, Arithmetic::double_precision,
                            [](const Measurement& m) { return m.judge_seconds; });
}

}  // namespace wedgesim::reports::stress
