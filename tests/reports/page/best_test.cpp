// Is the configuration that the page calls best the best one?
#include <gtest/gtest.h>

#include "reports/page/findings.h"
#include "reports/page/names.h"
#include "tests/reports/page/sample.h"

namespace wedgesim::reports::page {
namespace {

std::map<std::string, std::string> settings_of(const Best& best) {
  std::map<std::string, std::string> settings;
  for (const auto& [column, value] : best.settings) settings[column->key] = value_text(value);
  return settings;
}

TEST(Best, HasTheFewestBytesOverAllFrames) {
  const Results results = tests::counted_results();
  const Columns columns(results);
  const auto best = find_best(columns);
  ASSERT_TRUE(best);
  const std::map<std::string, std::string> expected{
      {"block.mode", "single-pass"}, {"block.tile", "8"}, {"block.cull", "both"}};
  EXPECT_EQ(settings_of(*best), expected);
  EXPECT_EQ(best->value.count, 6U);
  EXPECT_DOUBLE_EQ(best->behind.high, 1.0);
}

TEST(Best, IsJudgedByCyclesInTime) {
  const Results results = tests::timed_results();
  const Columns columns(results);
  const auto best = find_best(columns);
  ASSERT_TRUE(best);
  EXPECT_EQ(best->metric->key, "cycles");
  EXPECT_EQ(settings_of(*best)["z_read.cache_bytes"], "32,768");
  EXPECT_EQ(settings_of(*best)["memory.dram.preset"], "lpddr5-6400");
}

TEST(Best, OfWidthsAreTheNarrowestThatAreRightEverywhere) {
  const Results results = tests::precision_results();
  const Columns columns(results);
  const auto best = find_best(columns);
  ASSERT_TRUE(best);
  EXPECT_EQ(settings_of(*best)["formats.plane"], "14");
  EXPECT_EQ(settings_of(*best)["formats.reciprocal"], "8");
}

TEST(Best, AConfigurationThatLacksAFrameIsNotTheBest) {
  Results results = tests::counted_results();
  for (PointRow& point : results.points) {
    const bool was_best =
        std::get<std::string>(point.configuration["block.mode"]) == "single-pass" &&
        std::get<std::int64_t>(point.configuration["block.tile"]) == 8;
    if (was_best && point.frame.starts_with("fractal")) point.state = PointState::overtime;
  }
  const Columns columns(results);
  const auto best = find_best(columns);
  ASSERT_TRUE(best);
  EXPECT_NE(settings_of(*best)["block.mode"] + settings_of(*best)["block.tile"], "single-pass8");
}

TEST(Best, ThereIsNoneWithoutPoints) {
  Results results = tests::counted_results();
  results.points.clear();
  EXPECT_FALSE(find_best(Columns(results)));
}

}  // namespace
}  // namespace wedgesim::reports::page
