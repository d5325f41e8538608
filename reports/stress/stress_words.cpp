#include "reports/stress/stress_words.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/page/caption.h"
#include "reports/page/names.h"
#include "reports/stress/case_name.h"
#include "reports/stress/levels.h"
#include "reports/stress/stress_charts.h"

namespace wedgesim::reports::stress {
namespace {

std::string bound_words(const FamilyResult& result, Arithmetic arithmetic) {
  const std::optional<double> reached = result.holds_to(arithmetic);
  std::string words = reached ? "holds to " + difficulty_text(*reached) : "holds nowhere";
  if (result.holds_throughout(arithmetic)) words = "holds throughout";
  const auto required = result.required(arithmetic);
  if (!required || result.holds_throughout(arithmetic)) return words;
  return fmt::format("{} ({} {})", words,
                     result.meets_required(arithmetic) ? "must to" : "but must to",
                     difficulty_text(*required));
}

std::string throughout_words(const std::vector<FamilyResult>& results) {
  std::vector<std::string> parts;
  for (const Arithmetic a : kArithmetics) {
    const auto all = std::ranges::count_if(
        results, [a](const FamilyResult& r) { return r.holds_throughout(a); });
    parts.push_back(fmt::format("{} in {}", name_of(a), all));
  }
  return fmt::format("Of {} families, the bar holds at every difficulty for {}.", results.size(),
                     page::listed(parts));
}

std::string flagged_words(const std::vector<FamilyResult>& results) {
  std::vector<std::string> parts;
  for (const Arithmetic a : kArithmetics) {
    std::uint64_t beyond = 0;
    std::uint64_t unforeseen = 0;
    for (const FamilyResult& result : results) {
      for (const auto& level : result.levels) {
        const Errors worst = worst_of(level, a);
        beyond += worst.beyond;
        unforeseen += worst.unforeseen;
      }
    }
    parts.push_back(fmt::format("{} {} ({} of them at no foreseen wedge)", name_of(a),
                                page::number_text(static_cast<double>(beyond)),
                                page::number_text(static_cast<double>(unforeseen))));
  }
  return fmt::format("Pixels beyond the bar, over all difficulties: {}.", page::listed(parts));
}

std::string misfortune_words(const std::vector<FamilyResult>& results) {
  std::uint64_t not_finite = 0;
  std::uint64_t specks = 0;
  std::uint64_t leaks = 0;
  std::size_t disagreeing = 0;
  for (const FamilyResult& result : results) {
    for (const auto& level : result.levels) {
      for (const Arithmetic a : kArithmetics) {
        const Errors worst = worst_of(level, a);
        not_finite += worst.not_finite;
        specks += worst.specks;
        leaks += worst.leaks;
      }
      for (const Measurement& m : level) {
        disagreeing += !m.refused && !m.configurations_agree ? 1 : 0;
      }
    }
  }
  return fmt::format(
      "Contributions that are no number: {}; specks: {}; pixels away from penumbrae whose sum is "
      "not the exact whole number: {}, all arithmetics together; cases in which modes, cullings "
      "and tile sizes differ by a bit: {}.",
      not_finite, specks, leaks, disagreeing);
}

}  // namespace

std::string bounds_words(const FamilyResult& result) {
  std::vector<std::string> parts;
  for (const Arithmetic a : kArithmetics) {
    parts.push_back(fmt::format("{} {}", name_of(a), bound_words(result, a)));
  }
  return page::capital(page::listed(parts)) + ".";
}

std::string refused_words(const FamilyResult& result) {
  std::size_t refused = 0;
  std::string first;
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    for (const Measurement& m : result.levels[i]) {
      if (!m.refused) continue;
      if (refused++ > 0) continue;
      first = fmt::format("at {}: {}", difficulty_text(result.family->levels[i]), *m.refused);
    }
  }
  if (refused == 0) return "";
  return fmt::format("Refused: {}, first {}.",
                     refused == 1 ? "1 case" : fmt::format("{} cases", refused), first);
}

std::string broken_words(const Errors& errors) {
  if (errors.beyond > 0) {
    return fmt::format("{} {} beyond the bar, the worst {} beyond its sensitivity", errors.beyond,
                       errors.beyond == 1 ? "pixel" : "pixels", error_text(errors.max_excess));
  }
  if (errors.not_finite > 0) return "contributions that are no number";
  if (errors.leaks > 0) {
    return fmt::format("{} {} away from penumbrae whose sum is not the exact whole number",
                       errors.leaks, errors.leaks == 1 ? "pixel" : "pixels");
  }
  if (errors.rms <= kLargestRms && errors.rms_penumbra <= kLargestRms) {
    return fmt::format("a step across a plane off by {} beyond its sensitivity",
                       error_text(errors.jump ? errors.jump->excess : 0.0));
  }
  return fmt::format("an RMS error of {}, in penumbrae of {}, where {} is the bar",
                     error_text(errors.rms), error_text(errors.rms_penumbra),
                     error_text(kLargestRms));
}

std::vector<std::string> finding_words(const std::vector<FamilyResult>& results) {
  return {throughout_words(results), flagged_words(results), misfortune_words(results)};
}

}  // namespace wedgesim::reports::stress
