#include "functional/scene/triangulate.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numeric>
#include <random>

namespace wedgesim::functional {
namespace {

using Contours = std::vector<std::vector<std::uint32_t>>;

void add_contour(std::vector<GridPoint>& points, Contours& contours,
                 const std::vector<GridPoint>& contour) {
  std::vector<std::uint32_t>& indices = contours.emplace_back(contour.size());
  std::iota(indices.begin(), indices.end(), static_cast<std::uint32_t>(points.size()));
  points.insert(points.end(), contour.begin(), contour.end());
}

/// Every contour edge once, every other edge once in each direction.
bool edges_match(const Contours& contours,
                 const std::vector<std::array<std::uint32_t, 3>>& triangles) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[{t[k], t[(k + 1) % 3]}];
    }
  }
  for (const auto& contour : contours) {
    for (std::size_t k = 0; k < contour.size(); ++k) {
      --uses[{contour[k], contour[(k + 1) % contour.size()]}];
    }
  }
  return std::ranges::all_of(uses, [&](const auto& use) {
    const auto [edge, count] = use;
    const auto back = uses.find({edge.second, edge.first});
    return count == (back == uses.end() ? 0 : back->second) && count <= 1 && count >= 0;
  });
}

TEST(Triangulate, SquareWithTwoHolesInARow) {
  std::vector<GridPoint> points;
  Contours contours;
  add_contour(points, contours, {{0, 0}, {10, 0}, {10, 10}, {0, 10}});
  add_contour(points, contours, {{2, 4}, {2, 6}, {4, 6}, {4, 4}});
  add_contour(points, contours, {{6, 4}, {6, 6}, {8, 6}, {8, 4}});
  const auto triangles = triangulate(points, contours);
  EXPECT_EQ(triangles.size(), 4U + 8U + 2U);  // n + 2 holes - 2
  EXPECT_TRUE(edges_match(contours, triangles));
}

TEST(Triangulate, BridgesGoRoundWhatIsInTheWay) {
  // The corner nearest to the hole's right end is the tip of a spike behind a thin wall.
  std::vector<GridPoint> points;
  Contours contours;
  add_contour(points, contours,
              {{0, 0}, {100, 0}, {100, 100}, {62, 100}, {62, 20}, {60, 20}, {60, 100}, {0, 100}});
  add_contour(points, contours, {{40, 80}, {50, 90}, {55, 80}});
  std::vector<GridPoint> more;
  Contours walls;
  add_contour(
      more, walls,
      {{0, 0}, {100, 0}, {64, 80}, {100, 100}, {62, 100}, {62, 20}, {60, 20}, {60, 100}, {0, 100}});
  add_contour(more, walls, {{40, 80}, {50, 90}, {55, 80}});
  for (const auto& [p, c] : {std::pair(points, contours), std::pair(more, walls)}) {
    const auto triangles = triangulate(p, c);
    EXPECT_EQ(triangles.size(), p.size() + 2 - 2);
    EXPECT_TRUE(edges_match(c, triangles));
  }
}

TEST(Triangulate, CollinearCornersGiveNoEmptyTriangle) {
  std::vector<GridPoint> points;
  Contours contours;
  add_contour(points, contours,
              {{0, 0}, {5, 0}, {10, 0}, {10, 5}, {10, 10}, {5, 10}, {0, 10}, {0, 5}});
  const auto triangles = triangulate(points, contours);
  EXPECT_EQ(triangles.size(), 6U);
  EXPECT_TRUE(edges_match(contours, triangles));
}

TEST(Triangulate, RefusesAContourThatCrossesItself) {
  std::vector<GridPoint> points;
  Contours contours;
  add_contour(points, contours, {{0, 0}, {10, 10}, {10, 0}, {0, 12}});
  EXPECT_TRUE(triangulate(points, contours).empty());
}

TEST(Triangulate, RandomStarsWithStarHoles) {
  const unsigned seed = 20020903;
  SCOPED_TRACE(seed);
  std::mt19937 random(seed);
  const auto star = [&](GridPoint middle, double radius, int n, bool hole) {
    std::uniform_real_distribution<double> reach(0.3, 1.0);
    std::vector<GridPoint> contour;
    for (int i = 0; i < n; ++i) {
      const double angle = 6.283185307179586 * i / n;
      const double r = radius * reach(random);
      contour.push_back(
          middle + GridPoint(std::llround(r * std::cos(angle)), std::llround(r * std::sin(angle))));
    }
    if (hole) {
      std::ranges::reverse(contour);
    }
    return contour;
  };
  for (int round = 0; round < 200; ++round) {
    std::vector<GridPoint> points;
    Contours contours;
    add_contour(points, contours,
                {{-50000, -50000}, {50000, -50000}, {50000, 50000}, {-50000, 50000}});
    for (int i = 0; i < 9; ++i) {
      const GridPoint middle{30000 * (i % 3 - 1), 30000 * (i / 3 - 1)};
      const int corners = 3 + static_cast<int>(random() % 20);
      add_contour(points, contours, star(middle, 14000.0, corners, true));
    }
    const auto triangles = triangulate(points, contours);
    ASSERT_EQ(triangles.size(), points.size() + 2 * 9 - 2) << "round " << round;
    ASSERT_TRUE(edges_match(contours, triangles)) << "round " << round;
    Contours outside(1);
    std::vector<GridPoint> star_points = star({0, 0}, 60000.0, 40, false);
    outside[0].resize(star_points.size());
    std::iota(outside[0].begin(), outside[0].end(), 0U);
    ASSERT_EQ(triangulate(star_points, outside).size(), 38U) << "round " << round;
  }
}

}  // namespace
}  // namespace wedgesim::functional
