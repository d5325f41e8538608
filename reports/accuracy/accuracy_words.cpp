#include "reports/accuracy/accuracy_words.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/accuracy/accuracy_charts.h"
#include "reports/accuracy/equal_error.h"
#include "reports/accuracy/recommend.h"
#include "reports/page/caption.h"
#include "reports/table.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr double kGoodError = 0.01;  // RMSE on receivers

std::string with_numbers(const Measured& measured) {
  return fmt::format("{} ({} in {})", measured.choice.text, error_text(error_of(measured)),
                     time_text(seconds_of(measured)));
}

std::string good_words(const SceneResult& result) {
  const Recommendation found =
      recommend(result.methods, {.max_error = kGoodError, .budget_seconds = {}});
  if (!found.method) return fmt::format("No choice has an RMSE of at most {:g}.", kGoodError);
  const Measured& good = result.methods[*found.method];
  return fmt::format("Fastest with an RMSE of at most {:g}: {}.", kGoodError, with_numbers(good));
}

std::string between_words(std::size_t count) {
  return count == 0 ? std::string() : fmt::format("; {} more between them on the front", count);
}

std::string times_text(double ratio) {
  if (ratio < 1000.0) return fmt::format("{:.3g}", ratio);
  return grouped(static_cast<std::uint64_t>(std::llround(ratio)));
}

// The choice that ray tracing takes longest for, compared with its own time.
std::string ray_words(const SceneResult& result) {
  const Measured* best = nullptr;
  RayTraced rays;
  double most = 0.0;
  for (const Measured& measured : result.methods) {
    const std::optional<RayTraced> found = ray_traced_like(result.methods, measured);
    if (!found || error_of(measured) > kGoodError) continue;
    const double ratio = found->seconds / seconds_of(measured);
    if (ratio <= most) continue;
    best = &measured;
    rays = *found;
    most = ratio;
  }
  if (best == nullptr) return "";
  return fmt::format("For the error of {} ray tracing takes {}, {} times as long{}.",
                     best->choice.text, time_text(rays.seconds), times_text(most),
                     rays.extrapolated ? " (extrapolated)" : "");
}

}  // namespace

std::vector<std::string> finding_words(const SceneResult& result) {
  const std::vector<std::size_t> front = pareto_front(result.methods);
  if (front.empty()) return {"No choice renders the scene."};
  std::vector<std::string> words{good_words(result)};
  const std::string rays = ray_words(result);
  if (!rays.empty()) words.push_back(rays);
  const Measured& fastest = result.methods[front.front()];
  const Measured& best = result.methods[front.back()];
  if (front.size() > 1) {
    words.push_back(fmt::format("Fastest of all is {}, most exact {}{}.", with_numbers(fastest),
                                with_numbers(best), between_words(front.size() - 2)));
  } else {
    words.push_back(fmt::format("{} is both the fastest and the most exact.", with_numbers(best)));
  }
  return words;
}

std::vector<Refusal> refusals(const SceneResult& result) {
  std::vector<std::pair<std::string, std::vector<std::string>>> by_reason;
  for (const Measured& measured : result.methods) {
    if (!measured.refused) continue;
    auto found = std::ranges::find_if(
        by_reason, [&](const auto& entry) { return entry.first == *measured.refused; });
    if (found == by_reason.end()) found = by_reason.insert(found, {*measured.refused, {}});
    found->second.push_back(measured.choice.text);
  }
  std::vector<Refusal> all;
  for (const auto& [reason, choices] : by_reason) all.push_back({page::listed(choices), reason});
  return all;
}

}  // namespace wedgesim::reports::accuracy
