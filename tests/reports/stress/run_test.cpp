#include "reports/stress/run.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include "reports/stress/levels.h"
#include "reports/stress/stress_json.h"
#include "tests/reports/stress/sample.h"

namespace wedgesim::reports::stress {
namespace {

TEST(FamilyResult, HoldsUpToTheFirstFailure) {
  const auto results = tests::sample_results();
  const FamilyResult& steady = results[0];
  const FamilyResult& brittle = results[1];
  for (const Arithmetic a : kArithmetics) {
    EXPECT_EQ(steady.levels_held(a), 4U);
    EXPECT_EQ(steady.holds_to(a), 0.0);
  }
  EXPECT_EQ(brittle.levels_held(Arithmetic::fixed), 4U);  // refused is an answer here
  EXPECT_EQ(brittle.holds_to(Arithmetic::float32), 1.0);
  EXPECT_EQ(brittle.first_failure(Arithmetic::float32, 1), 1U);
  EXPECT_EQ(brittle.holds_to(Arithmetic::double_precision), 1e-3);
  EXPECT_EQ(brittle.first_failure(Arithmetic::double_precision, 2), 0U);
  EXPECT_EQ(brittle.holds_to(Arithmetic::renderer), 0.0);
}

TEST(FamilyResult, DoesNotHoldToLevelsThatAskNothing) {
  auto results = tests::sample_results();
  FamilyResult& steady = results[0];
  for (const std::size_t level : {1U, 3U}) {
    for (Measurement& m : steady.levels[level]) m.in_penumbra = 0;
  }
  EXPECT_EQ(steady.levels_held(Arithmetic::fixed), 4U);
  EXPECT_EQ(steady.holds_to(Arithmetic::fixed), 1e-4);
}

TEST(FamilyResult, ComplainsOfWhatIsWrong) {
  auto results = tests::sample_results();
  EXPECT_TRUE(results[0].complaints().empty());
  const std::vector<std::string> expected{
      "float32: 2 pixels beyond the bar belong to no foreseen wedge, the first in brittle,1,0.001",
      "double holds to 0.001, must hold to 1e-4",
      "double: 1 pixels beyond the bar belong to no foreseen wedge, the first in brittle,0,1e-4"};
  EXPECT_EQ(results[1].complaints(), expected);
  results[0].levels[3][1].configurations_agree = false;
  EXPECT_EQ(results[0].complaints().size(), 1U);
}

// What only shows beside another arithmetic excuses nothing.
TEST(FamilyResult, ComplainsOfWhatIsNotForeseen) {
  auto results = tests::sample_results();
  Measurement& m = results[0].levels[3][0];
  m.errors[static_cast<std::size_t>(Arithmetic::float32)].unflagged = 3;
  EXPECT_TRUE(results[0].complaints().empty());
  m.errors[static_cast<std::size_t>(Arithmetic::fixed)].unforeseen = 3;
  EXPECT_EQ(results[0].complaints(),
            std::vector<std::string>{"fixed: 3 pixels beyond the bar belong to no foreseen wedge, "
                                     "the first in steady,0,0"});
}

TEST(FamilyResult, ComplainsOfLevelsThatAskNothing) {
  auto results = tests::sample_results();
  FamilyResult& steady = results[0];
  for (const std::size_t level : {1U, 3U}) {  // the second one need not hold
    for (Measurement& m : steady.levels[level]) m.in_penumbra = 0;
  }
  steady.levels[2][0].in_penumbra = 0;  // the other seed's are enough
  EXPECT_EQ(steady.empty_levels(), std::vector{1e-3});
  EXPECT_EQ(steady.complaints(),
            std::vector<std::string>{"no pixel is in a penumbra at 0.001: nothing is asked"});
  Family excused = *steady.family;
  excused.empty_levels = {1e-3};
  steady.family = &excused;
  EXPECT_TRUE(steady.complaints().empty());
}

TEST(FamilyResult, TakesTheWorstAndTheMedianTime) {
  auto results = tests::sample_results();
  const Errors worst = worst_of(results[1].levels[2], Arithmetic::double_precision);
  EXPECT_EQ(worst.max_excess, 0.001);
  EXPECT_EQ(worst.beyond, 2U);
  EXPECT_FALSE(worst.holds);
  EXPECT_EQ(condition_of(results[0].levels[3]), 2000.0);
  results[0].levels[0][0].errors[0].seconds = 1.0;  // one case is disturbed
  EXPECT_NEAR(*nanoseconds_of(results[0], Arithmetic::fixed), 20.0, 1e-9);
  EXPECT_NEAR(*nanoseconds_of(results[0], Arithmetic::float32), 40.0, 1e-9);
  EXPECT_FALSE(nanoseconds_of(results[0], Arithmetic::renderer).has_value());
}

// All that is measured but times.
std::string measured(std::size_t threads) {
  const tbb::global_control control(tbb::global_control::max_allowed_parallelism, threads);
  const RunOptions options{{"frame-size", "distance-ratio"}, 2};
  Json json = stress_json(options, run(options, [](const Family&, std::size_t, std::size_t) {}));
  for (Json& family : json["families"]) family.erase("timing");
  return json.dump();
}

TEST(Run, TheSameOnAnyNumberOfThreads) { EXPECT_EQ(measured(1), measured(2)); }

TEST(Run, KeepsPicturesOfFirstFailuresAlone) {
  const RunOptions options{{"distance-ratio"}, 2};
  std::vector<std::string> said;
  const auto results = run(options, [&said](const Family& family, std::size_t, std::size_t) {
    said.emplace_back(family.name);
  });
  EXPECT_EQ(said, options.families);
  const FamilyResult& result = results.front();
  const std::size_t level = result.levels_held(Arithmetic::float32);
  ASSERT_LT(level, result.levels.size());
  const auto seed = result.first_failure(Arithmetic::float32, level);
  ASSERT_TRUE(seed.has_value());
  EXPECT_FALSE(result.levels[level][*seed].judge.empty());
  EXPECT_TRUE(result.levels[0][0].judge.empty());
}

}  // namespace
}  // namespace wedgesim::reports::stress
