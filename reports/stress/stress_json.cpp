#include "reports/stress/stress_json.h"

#include <cmath>

#include "reports/stress/levels.h"

namespace wedgesim::reports::stress {
namespace {

Json number(const std::optional<double>& value) { return value ? Json(*value) : Json(nullptr); }

std::size_t index(Arithmetic arithmetic) { return static_cast<std::size_t>(arithmetic); }

// Wedges as ranges, first and last: a frame may have 100,000 of them.
Json ranges_of(const std::vector<Flagged>& flagged) {
  Json ranges = Json::array();
  for (std::size_t i = 0; i < flagged.size();) {
    std::size_t last = i;
    while (last + 1 < flagged.size() && flagged[last + 1].reason == flagged[i].reason &&
           flagged[last + 1].foreseen == flagged[i].foreseen &&
           flagged[last + 1].wedge == flagged[last].wedge + 1) {
      ++last;
    }
    ranges.push_back({{"wedges", {flagged[i].wedge, flagged[last].wedge}},
                      {"reason", flagged[i].reason},
                      {"foreseen", flagged[i].foreseen}});
    i = last + 1;
  }
  return ranges;
}

// The worst of a level's seeds.
Json errors_json(const std::vector<Measurement>& seeds, Arithmetic arithmetic) {
  const Errors worst = worst_of(seeds, arithmetic);
  return {{"max_error", worst.max_error},
          {"max_excess", worst.max_excess},
          {"rms_error", worst.rms},
          {"rms_penumbra", worst.rms_penumbra},
          {"pixels_off", worst.off},
          {"pixels_beyond_bar", worst.beyond},
          {"pixels_beyond_bar_unflagged", worst.unflagged},
          {"pixels_beyond_bar_unforeseen", worst.unforeseen},
          {"specks", worst.specks},
          {"leaks", worst.leaks},
          {"jump", worst.jump ? Json(worst.jump->excess) : Json(nullptr)},
          {"signs", worst.signs},
          {"wrong_signs", worst.wrong_signs},
          {"not_finite", worst.not_finite},
          {"saturated", worst.saturated},
          {"overflowed", worst.overflowed},
          {"holds", worst.holds}};
}

Json levels_json(const FamilyResult& result) {
  Json levels = Json::array();
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const double condition = condition_of(result.levels[i]);
    std::size_t wedges = 0;
    std::size_t degenerate = 0;
    std::size_t judged = 0;
    std::size_t in_penumbra = 0;
    Json refused = Json::array();
    for (std::size_t seed = 0; seed < result.levels[i].size(); ++seed) {
      const Measurement& m = result.levels[i][seed];
      if (m.refused) {
        refused.push_back({{"seed", seed}, {"why", *m.refused}});
        continue;
      }
      wedges += m.wedges;
      degenerate += m.degenerate_wedges;
      judged += m.judged;
      in_penumbra += m.in_penumbra;
    }
    Json level{{"difficulty", result.family->levels[i]},
               {"condition", std::isfinite(condition) ? Json(condition) : Json(nullptr)},
               {"wedges", wedges},
               {"degenerate_wedges", degenerate},
               {"pixels", judged},
               {"pixels_in_penumbra", in_penumbra},
               {"refused", refused}};
    for (const Arithmetic a : kArithmetics) {
      level["arithmetics"][name_of(a)] = errors_json(result.levels[i], a);
    }
    levels.push_back(std::move(level));
  }
  return levels;
}

Json flagged_json(const FamilyResult& result) {
  Json flagged = Json::array();
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    for (std::size_t seed = 0; seed < result.levels[i].size(); ++seed) {
      for (const Arithmetic a : kArithmetics) {
        const Measurement& m = result.levels[i][seed];
        if (m.flagged[index(a)].empty()) continue;
        flagged.push_back({{"family", result.family->name},
                           {"seed", seed},
                           {"difficulty", result.family->levels[i]},
                           {"arithmetic", name_of(a)},
                           {"pixels_beyond_bar", m.errors[index(a)].beyond},
                           {"ranges", ranges_of(m.flagged[index(a)])}});
      }
    }
  }
  return flagged;
}

Json timing_of(const FamilyResult& result) {
  Json timing = Json::object();
  for (const Arithmetic a :
       {Arithmetic::fixed, Arithmetic::float32, Arithmetic::double_precision}) {
    timing[std::string(name_of(a))] = number(nanoseconds_of(result, a));
  }
  timing["judge"] = number(judge_nanoseconds_of(result));
  return timing;
}

Json family_json(const FamilyResult& result) {
  const Family& family = *result.family;
  Json json{{"name", family.name},
            {"parameter", family.parameter},
            {"unit", family.unit},
            {"arithmetics", Json::object()},
            {"holds_to", Json::object()},
            {"required", Json::object()},
            {"complaints", result.complaints()},
            {"held", result.complaints().empty()},
            {"levels", levels_json(result)}};
  for (const Arithmetic a : kArithmetics) {
    const std::string name(name_of(a));
    const std::size_t held = result.levels_held(a);
    Json entry{{"tolerance", tolerance_of(a)},
               {"holds_to", number(result.holds_to(a))},
               {"required", number(result.required(a))},
               {"first_broken", nullptr}};
    if (held < result.levels.size()) {
      const auto seed = result.first_failure(a, held);
      entry["first_broken"] = {{"difficulty", family.levels[held]},
                               {"seed", seed ? Json(*seed) : Json(nullptr)}};
    }
    json["arithmetics"][name] = std::move(entry);
    json["holds_to"][name] = number(result.holds_to(a));
    json["required"][name] = number(result.required(a));
  }
  json["timing"]["nanoseconds_a_contribution"] = timing_of(result);
  return json;
}

}  // namespace

Json stress_json(const RunOptions& options, const std::vector<FamilyResult>& results) {
  Json json;
  json["schema"] = "wedgesim.stress/1";
  json["configuration"] = {{"seeds", options.seeds}, {"rms_bar", kLargestRms}};
  for (const Arithmetic a : kArithmetics) {
    json["configuration"]["tolerance"][name_of(a)] = tolerance_of(a);
  }
  json["families"] = Json::array();
  json["flagged"] = Json::array();
  for (const FamilyResult& result : results) {
    json["families"].push_back(family_json(result));
    for (Json& flag : flagged_json(result)) json["flagged"].push_back(std::move(flag));
  }
  return json;
}

}  // namespace wedgesim::reports::stress
