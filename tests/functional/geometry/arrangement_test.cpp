#include "functional/geometry/arrangement.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>

#include "functional/geometry/sweep_line.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kNoUmbra = std::numeric_limits<int>::max();

// Closed loops through random points, some of them many times the same.
std::vector<GridSegment> random_loops(Random& random, int loops, int corners, int range) {
  std::vector<GridSegment> segments;
  for (int i = 0; i < loops; ++i) {
    std::vector<GridPoint> points;
    for (int j = 0; j < corners; ++j) {
      points.push_back({2 * random.whole(-range, range), 2 * random.whole(-range, range)});
    }
    for (std::size_t j = 0; j < points.size(); ++j) {
      segments.push_back({points[j], points[(j + 1) % points.size()], 1});
    }
  }
  return segments;
}

// Edges that meet other than at common ends, by looking at every pair.
int faults_of(const Arrangement& arrangement) {
  const auto& v = arrangement.vertices;
  int faults = 0;
  for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
    const GridPoint& a = v[arrangement.edges[i].begin];
    const GridPoint& b = v[arrangement.edges[i].end];
    if (!(a < b)) ++faults;
    for (const GridPoint& p : v) {
      if (a < p && p < b && turn(a, b, p) == 0) ++faults;
    }
    for (std::size_t j = 0; j < i; ++j) {
      const GridPoint& c = v[arrangement.edges[j].begin];
      const GridPoint& d = v[arrangement.edges[j].end];
      const auto apart = [](std::int64_t s, std::int64_t t) { return (s < 0) == (t < 0); };
      if (turn(a, b, c) != 0 && turn(a, b, d) != 0 && turn(c, d, a) != 0 && turn(c, d, b) != 0 &&
          !apart(turn(a, b, c), turn(a, b, d)) && !apart(turn(c, d, a), turn(c, d, b))) {
        ++faults;
      }
    }
  }
  return faults;
}

// The winding number of segments about a point that lies on none of them.
int winding(const std::vector<GridSegment>& segments, const GridPoint& p) {
  int sum = 0;
  for (const GridSegment& s : segments) {
    const bool rises = s.begin.x <= p.x && s.end.x > p.x && turn(s.begin, s.end, p) > 0;
    const bool falls = s.end.x <= p.x && s.begin.x > p.x && turn(s.end, s.begin, p) > 0;
    sum += rises ? s.weight : falls ? -s.weight : 0;
  }
  return sum;
}

std::vector<GridSegment> segments_of(const Arrangement& arrangement) {
  std::vector<GridSegment> segments;
  for (const auto& edge : arrangement.edges) {
    segments.push_back(
        {arrangement.vertices[edge.begin], arrangement.vertices[edge.end], edge.rise});
  }
  return segments;
}

TEST(Arrange, CutsACross) {
  const std::vector<GridSegment> cross{{{-10, -10}, {10, 10}, 1}, {{-10, 10}, {10, -10}, 1}};
  const Arrangement found = arrange(cross);
  EXPECT_EQ(found.vertices,
            (std::vector<GridPoint>{{-10, -10}, {-10, 10}, {0, 0}, {10, -10}, {10, 10}}));
  EXPECT_EQ(found.edges.size(), 4U);
}

TEST(Arrange, AddsWhatIsCoincidentAndDropsWhatCancels) {
  const Arrangement twice =
      arrange(std::vector<GridSegment>{{{0, 0}, {8, 4}, 1}, {{4, 2}, {12, 6}, 1}});
  ASSERT_EQ(twice.edges.size(), 3U);
  EXPECT_EQ(twice.edges[0].rise, 1);
  EXPECT_EQ(twice.edges[1].rise, 2);
  EXPECT_EQ(twice.edges[2].rise, 1);
  const Arrangement none =
      arrange(std::vector<GridSegment>{{{0, 0}, {8, 4}, 1}, {{8, 4}, {0, 0}, 1}});
  EXPECT_TRUE(none.edges.empty());
  EXPECT_TRUE(none.vertices.empty());
  EXPECT_TRUE(arrange({}).edges.empty());
}

TEST(Arrange, ASegmentThatTouchesAnotherCutsIt) {
  const Arrangement found =
      arrange(std::vector<GridSegment>{{{0, 0}, {20, 0}, 1}, {{10, 0}, {10, 8}, 1}});
  EXPECT_EQ(found.edges.size(), 3U);
}

// On a coarse grid nearly every intersection is rounded onto something else.
TEST(Arrange, LeavesNoIntersectionHoweverCoarseTheGrid) {
  Random random(611);
  for (const int range : {2, 4, 12, 60, 1 << 26}) {
    for (int i = 0; i < 60; ++i) {
      const auto segments = random_loops(random, 2, 12, range);
      ASSERT_EQ(faults_of(arrange(segments)), 0) << "range " << range << ", case " << i;
    }
  }
}

TEST(Arrange, KeepsWindingNumbersAwayFromEdges) {
  Random random(612);
  constexpr int kRange = 1 << 20;
  int different = 0;
  for (int i = 0; i < 20; ++i) {
    const auto segments = random_loops(random, 3, 9, kRange);
    const auto cut = segments_of(arrange(segments));
    for (int j = 0; j < 500; ++j) {
      const GridPoint p{2 * random.whole(-kRange, kRange) + 1,
                        2 * random.whole(-kRange, kRange) + 1};
      if (winding(cut, p) != winding(segments, p)) ++different;
    }
  }
  EXPECT_LE(different, 1) << "a point may be within rounding of an edge";
}

TEST(SweepLine, CountsWindingsFromBelow) {
  Random random(613);
  for (const int range : {3, 30, 1 << 20}) {
    for (int i = 0; i < 40; ++i) {
      Arrangement found = arrange(random_loops(random, 3, 7, range));
      const Sweep sweep = sweep_line(found, kNoUmbra);
      // About the middle of each edge, a little below it: on a grid four times as fine.
      for (auto& v : found.vertices) v = {4 * v.x, 4 * v.y};
      const auto segments = segments_of(found);
      for (std::size_t e = 0; e < found.edges.size(); ++e) {
        const GridPoint& a = found.vertices[found.edges[e].begin];
        const GridPoint& b = found.vertices[found.edges[e].end];
        if (a.x == b.x) continue;
        const GridPoint middle{(a.x + b.x) / 2, (a.y + b.y) / 2};
        int below = 0;
        for (const auto& s : segments) {
          const auto [l, r] = std::minmax(s.begin, s.end);
          const bool spans = l.x <= middle.x && r.x > middle.x;
          const bool own = l == a && r == b;
          if (spans && !own && turn(l, r, middle) > 0) below += s.begin == l ? s.weight : -s.weight;
        }
        ASSERT_EQ(sweep.below[e], below) << "range " << range << ", case " << i;
      }
    }
  }
}

TEST(SweepLine, TrapezoidsAddUpToTheArea) {
  Random random(614);
  for (int i = 0; i < 40; ++i) {
    const Arrangement found = arrange(random_loops(random, 3, 8, 1 << 20));
    for (const int full : {1, 2, 3}) {
      const Sweep sweep = sweep_line(found, full);
      double area = 0.0;
      for (const Trapezoid& t : sweep.trapezoids) {
        const auto y_at = [](const std::array<GridPoint, 2>& edge, double x) {
          return edge[0].y + (x - edge[0].x) * (static_cast<double>(edge[1].y) - edge[0].y) /
                                 (static_cast<double>(edge[1].x) - edge[0].x);
        };
        const double middle = 0.5 * (static_cast<double>(t.x_begin) + t.x_end);
        const double height = y_at(t.upper, middle) - y_at(t.lower, middle);
        EXPECT_GE(height, 0.0);
        area += height * (static_cast<double>(t.x_end) - t.x_begin);
      }
      double expected = 0.0;  // by the outline
      for (std::size_t e = 0; e < found.edges.size(); ++e) {
        const bool below = sweep.below[e] >= full;
        const bool above = sweep.below[e] + found.edges[e].rise >= full;
        const GridPoint& a = found.vertices[found.edges[e].begin];
        const GridPoint& b = found.vertices[found.edges[e].end];
        const double part =
            0.5 * (static_cast<double>(a.y) + b.y) * (static_cast<double>(b.x) - a.x);
        if (below != above) expected += above ? -part : part;
      }
      ASSERT_NEAR(area, expected, 1e-9 * (1LL << 44)) << "case " << i << ", full " << full;
    }
  }
}

TEST(SweepLine, BridgesConnectWhatLiesInside) {
  std::vector<GridSegment> squares;
  const auto add = [&](std::int32_t x, std::int32_t y, std::int32_t half) {
    const std::array<GridPoint, 4> c{GridPoint{x - half, y - half}, GridPoint{x + half, y - half},
                                     GridPoint{x + half, y + half}, GridPoint{x - half, y + half}};
    for (std::size_t i = 0; i < 4; ++i) squares.push_back({c[i], c[(i + 1) % 4], 1});
  };
  add(0, 0, 100);
  add(-40, 0, 20);
  add(40, 10, 20);
  add(300, 0, 50);
  const Arrangement found = arrange(squares);
  EXPECT_EQ(sweep_line(found, 2).bridges.size(), 2U);
  EXPECT_TRUE(sweep_line(found, 1).bridges.empty()) << "no penumbra";
}

}  // namespace
}  // namespace wedgesim::functional
