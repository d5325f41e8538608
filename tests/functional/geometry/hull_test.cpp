#include "functional/geometry/hull.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

using Points = std::vector<glm::dvec2>;

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

// Points on a grid have many equal, collinear and repeated ones.
Points random_points(Random& random) {
  Points points;
  const int count = random.whole(1, 30);
  const bool grid = random.chance(0.5);
  for (int i = 0; i < count; ++i) {
    if (grid) {
      points.emplace_back(random.whole(0, 4), random.whole(0, 4));
    } else {
      points.emplace_back(random.uniform(-1.0, 1.0), random.uniform(-1.0, 1.0));
    }
  }
  return points;
}

// Is every point inside the hull, is the hull counter-clockwise, and does it name corners only?
TEST(Hull, HoldsAllPointsAndTurnsLeft) {
  Random random(61);
  for (int i = 0; i < 5000; ++i) {
    const Points points = random_points(random);
    const Points hull = convex_hull(points);
    ASSERT_FALSE(hull.empty());
    if (hull.size() < 3) continue;
    for (std::size_t k = 0; k < hull.size(); ++k) {
      const glm::dvec2& a = hull[k];
      const glm::dvec2& b = hull[(k + 1) % hull.size()];
      ASSERT_GT(turn(a, b, hull[(k + 2) % hull.size()]), 0.0) << "case " << i;
      for (const glm::dvec2& p : points) ASSERT_GE(turn(a, b, p), -1e-15) << "case " << i;
    }
  }
}

TEST(Hull, IndicesNameTheFirstOfEqualPoints) {
  const Points points{{1, 1}, {0, 0}, {2, 0}, {0, 0}, {2, 2}, {1, 0}, {0, 2}, {2, 2}};
  EXPECT_EQ(convex_hull_indices(points), (std::vector<std::size_t>{1, 2, 4, 6}));
}

TEST(Hull, PointsWithoutArea) {
  EXPECT_EQ(convex_hull({{1, 2}}).size(), 1U);
  EXPECT_EQ(convex_hull({{1, 2}, {1, 2}, {1, 2}}).size(), 1U);
  EXPECT_EQ(convex_hull({{0, 0}, {1, 1}, {3, 3}, {2, 2}}).size(), 2U);
  EXPECT_TRUE(convex_hull({}).empty());
}

}  // namespace
}  // namespace wedgesim::functional
