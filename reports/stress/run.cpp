#include "reports/stress/run.h"

#include <fmt/format.h>
#include <tbb/parallel_for.h>

#include <algorithm>

#include "reports/stress/case_name.h"
#include "reports/stress/levels.h"

namespace wedgesim::reports::stress {
namespace {

bool answered(const Family& family, const Measurement& measurement, Arithmetic arithmetic) {
  if (measurement.refused) return family.may_refuse;
  return measurement.errors[static_cast<std::size_t>(arithmetic)].holds;
}

// Whether a level has a pixel that can be wrong, or a frame that is refused.
bool asks(const std::vector<Measurement>& level) {
  return std::ranges::any_of(
      level, [](const Measurement& m) { return m.refused.has_value() || m.in_penumbra > 0; });
}

void drop_pictures(Measurement& measurement) {
  measurement.judge = {};
  measurement.sensitivities = {};
  for (Errors& errors : measurement.errors) errors.li = {};
}

FamilyResult measure_family(const Family& family, std::uint64_t most_seeds) {
  const std::uint64_t seeds = family.seeded ? most_seeds : 1;
  FamilyResult result;
  result.family = &family;
  result.levels.assign(family.levels.size(), std::vector<Measurement>(seeds));
  const std::size_t cases = family.levels.size() * seeds;
  tbb::parallel_for(std::size_t{0}, cases, [&](std::size_t i) {
    const std::size_t level = i / seeds;
    const std::uint64_t seed = i % seeds;
    result.levels[level][seed] = measure(family.make(seed, family.levels[level]));
  });
  return result;
}

// Pictures are of the first failure of each arithmetic alone.
void keep_first_failures(FamilyResult& result) {
  std::vector<const Measurement*> kept;
  for (const Arithmetic arithmetic : kArithmetics) {
    const std::size_t level = result.levels_held(arithmetic);
    if (level == result.levels.size()) continue;
    if (const auto seed = result.first_failure(arithmetic, level)) {
      kept.push_back(&result.levels[level][*seed]);
    }
  }
  for (auto& level : result.levels) {
    for (Measurement& measurement : level) {
      if (std::find(kept.begin(), kept.end(), &measurement) == kept.end()) {
        drop_pictures(measurement);
      }
    }
  }
}

}  // namespace

std::size_t FamilyResult::levels_held(Arithmetic arithmetic) const {
  std::size_t held = 0;
  for (const auto& level : levels) {
    const bool all = std::all_of(level.begin(), level.end(), [&](const Measurement& m) {
      return answered(*family, m, arithmetic);
    });
    if (!all) break;
    ++held;
  }
  return held;
}

std::optional<double> FamilyResult::holds_to(Arithmetic arithmetic) const {
  std::size_t held = levels_held(arithmetic);
  while (held > 0 && !asks(levels[held - 1])) --held;
  if (held == 0) return {};
  return family->levels[held - 1];
}

bool FamilyResult::holds_throughout(Arithmetic arithmetic) const {
  return holds_to(arithmetic) == family->levels.back();
}

bool FamilyResult::meets_required(Arithmetic arithmetic) const {
  const auto must = required(arithmetic);
  return !must || levels_held(arithmetic) >= levels_up_to(*must);
}

std::optional<double> FamilyResult::required(Arithmetic arithmetic) const {
  if (arithmetic == Arithmetic::fixed) return family->required.fixed;
  if (arithmetic == Arithmetic::float32) return {};
  return family->required.double_precision;
}

std::optional<std::uint64_t> FamilyResult::first_failure(Arithmetic arithmetic,
                                                         std::size_t level) const {
  for (std::uint64_t seed = 0; seed < levels[level].size(); ++seed) {
    const Measurement& m = levels[level][seed];
    if (!m.refused && !answered(*family, m, arithmetic)) return seed;
  }
  return {};
}

std::vector<double> FamilyResult::empty_levels() const {
  std::size_t needed = 0;
  for (const Arithmetic arithmetic : kArithmetics) {
    if (const auto must = required(arithmetic)) needed = std::max(needed, levels_up_to(*must));
  }
  std::vector<double> empty;
  for (std::size_t i = 0; i < needed; ++i) {
    const bool some =
        std::ranges::any_of(levels[i], [](const Measurement& m) { return m.in_penumbra > 0; });
    if (!some) empty.push_back(family->levels[i]);
  }
  return empty;
}

std::size_t FamilyResult::levels_up_to(double difficulty) const {
  const auto position = std::ranges::find(family->levels, difficulty);
  return static_cast<std::size_t>(position - family->levels.begin()) + 1;
}

std::vector<std::string> FamilyResult::complaints() const {
  std::vector<std::string> complaints;
  for (const double level : empty_levels()) {
    if (std::ranges::count(family->empty_levels, level) > 0) continue;
    complaints.push_back(
        fmt::format("no pixel is in a penumbra at {}: nothing is asked", difficulty_text(level)));
  }
  for (const Arithmetic arithmetic : kArithmetics) {
    if (!meets_required(arithmetic)) {
      const auto reached = holds_to(arithmetic);
      complaints.push_back(fmt::format("{} holds to {}, must hold to {}", name_of(arithmetic),
                                       reached ? difficulty_text(*reached) : "nothing",
                                       difficulty_text(*required(arithmetic))));
    }
    std::uint64_t silent = 0;
    std::string first;
    for (std::size_t level = 0; level < levels.size(); ++level) {
      for (std::size_t seed = 0; seed < levels[level].size(); ++seed) {
        const Measurement& m = levels[level][seed];
        silent += m.errors[static_cast<std::size_t>(arithmetic)].unforeseen;
        if (silent == 0 || !first.empty()) continue;
        first = fmt::format("{},{},{}", family->name, seed, difficulty_text(family->levels[level]));
      }
    }
    if (silent > 0) {
      complaints.push_back(
          fmt::format("{}: {} pixels beyond the bar belong to no foreseen wedge, the first in {}",
                      name_of(arithmetic), silent, first));
    }
  }
  for (const auto& level : levels) {
    for (const Measurement& m : level) {
      if (!m.refused && !m.configurations_agree) {
        complaints.push_back("modes, cullings and tile sizes do not agree");
        return complaints;
      }
    }
  }
  return complaints;
}

std::vector<FamilyResult> run(const RunOptions& options, const Progress& progress) {
  std::vector<const Family*> chosen;
  for (const std::string& name : options.families) chosen.push_back(&find_family(name));
  if (chosen.empty()) {
    for (const Family& family : families()) chosen.push_back(&family);
  }
  std::vector<FamilyResult> results;
  for (const Family* family : chosen) {
    progress(*family, results.size(), chosen.size());
    results.push_back(measure_family(*family, options.seeds));
    keep_first_failures(results.back());
  }
  return results;
}

}  // namespace wedgesim::reports::stress
