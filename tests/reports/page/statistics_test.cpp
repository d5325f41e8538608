// Are the numbers that the page speaks of right?
#include "reports/page/statistics.h"

#include <gtest/gtest.h>

namespace wedgesim::reports::page {
namespace {

TEST(Statistics, MedianAndPercentilesLieBetweenNeighbours) {
  const auto spread = spread_of({4.0, 1.0, 3.0, 2.0, 5.0});
  ASSERT_TRUE(spread);
  EXPECT_DOUBLE_EQ(spread->median, 3.0);
  EXPECT_DOUBLE_EQ(spread->low, 1.2);
  EXPECT_DOUBLE_EQ(spread->high, 4.8);
  EXPECT_EQ(spread->count, 5U);
  EXPECT_FALSE(spread_of({}));
}

TEST(Statistics, SlopeOfAPowerIsItsExponent) {
  const auto slope = log_slope({{1.0, 3.0}, {10.0, 3.0 * std::pow(10.0, 1.5)}, {100.0, 3000.0}});
  ASSERT_TRUE(slope);
  EXPECT_NEAR(*slope, 1.5, 1e-12);
}

TEST(Statistics, NoSlopeWithoutTwoPositivePlaces) {
  EXPECT_FALSE(log_slope({{1.0, 3.0}}));
  EXPECT_FALSE(log_slope({{2.0, 3.0}, {2.0, 4.0}}));
  EXPECT_FALSE(log_slope({{1.0, 3.0}, {0.0, 4.0}, {2.0, -1.0}}));
}

}  // namespace
}  // namespace wedgesim::reports::page
