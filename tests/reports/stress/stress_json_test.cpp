#include "reports/stress/stress_json.h"

#include <gtest/gtest.h>

#include "tests/reports/stress/sample.h"

namespace wedgesim::reports::stress {
namespace {

std::vector<std::string> keys_of(const Json& json) {
  std::vector<std::string> keys;
  for (const auto& [key, value] : json.items()) keys.push_back(key);
  return keys;
}

using Keys = std::vector<std::string>;

// docs/stress.md names them.
TEST(StressJson, HasTheDocumentedKeys) {
  const Json json = stress_json({}, tests::sample_results());
  EXPECT_EQ(json["schema"], "wedgesim.stress/1");
  EXPECT_EQ(keys_of(json), (Keys{"schema", "configuration", "families", "flagged"}));
  const Json& family = json["families"][1];
  EXPECT_EQ(keys_of(family), (Keys{"name", "parameter", "unit", "arithmetics", "holds_to",
                                   "required", "complaints", "held", "levels", "timing"}));
  EXPECT_EQ(keys_of(family["arithmetics"]), (Keys{"fixed", "float32", "double", "renderer"}));
  EXPECT_EQ(keys_of(family["arithmetics"]["double"]),
            (Keys{"tolerance", "holds_to", "required", "first_broken"}));
  const Json& level = family["levels"][2];
  EXPECT_EQ(keys_of(level), (Keys{"difficulty", "condition", "wedges", "degenerate_wedges",
                                  "pixels", "pixels_in_penumbra", "refused", "arithmetics"}));
  EXPECT_EQ(keys_of(level["arithmetics"]["double"]),
            (Keys{"max_error", "max_excess", "rms_error", "rms_penumbra", "pixels_off",
                  "pixels_beyond_bar", "pixels_beyond_bar_unflagged",
                  "pixels_beyond_bar_unforeseen", "specks", "leaks", "jump", "signs", "wrong_signs",
                  "not_finite", "saturated", "overflowed", "holds"}));
}

TEST(StressJson, SaysHowFarEachHolds) {
  const Json json = stress_json({}, tests::sample_results());
  EXPECT_EQ(json["families"][0]["held"], true);
  const Json& brittle = json["families"][1];
  EXPECT_EQ(brittle["held"], false);
  EXPECT_EQ(brittle["holds_to"]["float32"], 1.0);
  EXPECT_EQ(brittle["required"]["double"], 1e-4);
  EXPECT_EQ(brittle["required"]["float32"], nullptr);
  const Json broken{{"difficulty", 1e-3}, {"seed", 1}};
  EXPECT_EQ(brittle["arithmetics"]["float32"]["first_broken"], broken);
  EXPECT_EQ(brittle["levels"][3]["refused"].size(), 2U);
  EXPECT_NEAR(brittle["timing"]["nanoseconds_a_contribution"]["float32"].get<double>(), 40.0, 1e-9);
}

TEST(StressJson, ListsFlaggedWedgesAsRanges) {
  auto results = tests::sample_results();
  auto& flagged =
      results[1].levels[2][0].flagged[static_cast<std::size_t>(Arithmetic::double_precision)];
  flagged = {{3, "thin"}, {4, "thin"}, {5, "thin", true}, {6, "wide"}, {9, "wide"}};
  const Json json = stress_json({}, results);
  ASSERT_EQ(json["flagged"].size(), 1U);
  EXPECT_EQ(json["flagged"][0]["family"], "brittle");
  EXPECT_EQ(json["flagged"][0]["difficulty"], 1e-4);
  EXPECT_EQ(json["flagged"][0]["pixels_beyond_bar"], 2);
  const auto range = [](int first, int last, const char* reason, bool foreseen) {
    return Json{{"wedges", {first, last}}, {"reason", reason}, {"foreseen", foreseen}};
  };
  const Json ranges = Json::array({range(3, 4, "thin", false), range(5, 5, "thin", true),
                                   range(6, 6, "wide", false), range(9, 9, "wide", false)});
  EXPECT_EQ(json["flagged"][0]["ranges"], ranges);
}

}  // namespace
}  // namespace wedgesim::reports::stress
