#include "reports/accesses.h"

#include <gtest/gtest.h>

#include "tests/reports/results.h"

namespace wedgesim::reports {
namespace {

TEST(Accesses, AreReadsAndWrites) {
  const Accesses accesses = accesses_of(make_result({}, 1000, 500, 400));
  EXPECT_EQ(accesses.reads, 1000U);
  EXPECT_EQ(accesses.writes, 500U);
  EXPECT_EQ(accesses.visits, 400U);
  EXPECT_EQ(accesses.total(), 1500U);
}

TEST(Accesses, StandOverTheFloor) {
  EXPECT_EQ(floor_of(make_result({}, 1000, 500)), 150U);
  EXPECT_DOUBLE_EQ(*over_floor(make_result({}, 1000, 500)), 10.0);
}

TEST(Accesses, SavedIsInPerCentOfTheFirst) {
  EXPECT_DOUBLE_EQ(*saved_percent(200, 150), 25.0);
  EXPECT_DOUBLE_EQ(*saved_percent(100, 130), -30.0);
  EXPECT_FALSE(saved_percent(0, 5).has_value());
}

}  // namespace
}  // namespace wedgesim::reports
