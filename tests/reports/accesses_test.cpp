#include "reports/accesses.h"

#include <gtest/gtest.h>

#include "tests/reports/results.h"

namespace wedgesim::reports {
namespace {

struct AccessesTest : testing::Test {
  StudyResults results = make_study_results();
  const SceneResults& scene = results.scenes.front();
};

TEST_F(AccessesTest, AreReadsAndWrites) {
  const Accesses accesses = accesses_of(scene.results.front());
  EXPECT_EQ(accesses.reads, 1000U);
  EXPECT_EQ(accesses.writes, 500U);
  EXPECT_EQ(accesses.visits, 400U);
  EXPECT_EQ(accesses.total(), 1500U);
}

TEST_F(AccessesTest, AreFoundByConfiguration) {
  EXPECT_EQ(find(scene, results.study.configs[2]), &scene.results[2]);
  model::CountConfig other = results.study.configs[2];
  other.cull = model::Cull::none;
  EXPECT_EQ(find(scene, other), nullptr);
}

TEST_F(AccessesTest, SavedIsInPerCentOfTheFirst) {
  EXPECT_DOUBLE_EQ(*saved_percent(200, 150), 25.0);
  EXPECT_DOUBLE_EQ(*saved_percent(100, 130), -30.0);
  EXPECT_FALSE(saved_percent(0, 5).has_value());
}

TEST_F(AccessesTest, TheBestTileDependsOnWhatAVisitCosts) {
  // single-pass: tile 4 costs 1250 + 300 a visit, tile 8 costs 1500 + 80: equal at 1.14 a visit.
  const model::CountConfig config;
  EXPECT_EQ(best_tile(results, scene, config, 0), 4U);
  EXPECT_EQ(best_tile(results, scene, config, 1), 4U);
  EXPECT_EQ(best_tile(results, scene, config, 2), 8U);
  model::CountConfig unknown;
  unknown.cull = model::Cull::none;
  EXPECT_EQ(best_tile(results, scene, unknown, 0), 0U);
}

}  // namespace
}  // namespace wedgesim::reports
