#include "model/count/raster.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

#include "tests/support/repetitions.h"

namespace wedgesim::model {
namespace {

std::vector<int> coverage(const std::vector<std::vector<Snapped>>& polygons, int width,
                          int height) {
  std::vector<int> covered(static_cast<std::size_t>(width * height));
  for (const auto& vertices : polygons) {
    const Outline outline(vertices);
    for (int y = std::max(0, outline.row_begin()); y < std::min(height, outline.row_end()); ++y) {
      const Span span = outline.row(y, width);
      for (int x = span.begin; x < span.end; ++x)
        covered[static_cast<std::size_t>(y * width + x)]++;
    }
  }
  return covered;
}

TEST(Outline, TellsFacingFromTheSnappedArea) {
  // Counter-clockwise with y up is clockwise with y down.
  const std::vector<Snapped> eye{{0, 0}, {0, 512}, {512, 512}};
  const std::vector<Snapped> away{{0, 0}, {512, 512}, {0, 512}};
  EXPECT_TRUE(Outline(eye).eye_facing());
  EXPECT_FALSE(Outline(away).eye_facing());
  EXPECT_FALSE(Outline(away).empty());
}

TEST(Outline, CoversNothingWithoutArea) {
  const std::vector<Snapped> line{{0, 0}, {512, 512}, {1024, 1024}};
  const Outline outline(line);
  EXPECT_TRUE(outline.empty());
  EXPECT_FALSE(outline.covers(0, 0));
  EXPECT_TRUE(Outline(std::vector<Snapped>{}).empty());
}

TEST(Outline, LeftAndTopEdgesThroughCentresAreInside) {
  // The centres of (1, 1) ... (3, 3) are on the corners and edges of this square.
  const std::vector<Snapped> square{{384, 384}, {896, 384}, {896, 896}, {384, 896}};
  const Outline outline(square);
  for (int y = 0; y < 5; ++y) {
    for (int x = 0; x < 5; ++x) {
      EXPECT_EQ(outline.covers(x, y), x >= 1 && x <= 2 && y >= 1 && y <= 2) << x << ' ' << y;
    }
  }
}

TEST(Outline, ClipsToTheFrame) {
  const std::vector<Snapped> huge{{-(1 << 24), -(1 << 24)}, {1 << 24, -(1 << 24)}, {0, 1 << 24}};
  const Outline outline(huge);
  EXPECT_EQ(outline.row(3, 7).begin, 0);
  EXPECT_EQ(outline.row(3, 7).end, 7);
}

TEST(Outline, AlmostHorizontalEdgesFarAwayDoNotOverflow) {
  const std::vector<Snapped> sliver{{-(1 << 24), 0}, {1 << 24, 1}, {1 << 24, 1 << 24}};
  EXPECT_FALSE(Outline(sliver).covers(0, 60000));
  EXPECT_TRUE(Outline(sliver).covers(60000, 3));
}

TEST(Outline, ATriangulatedGridCoversEveryPixelOnce) {
  for (unsigned seed = 1; seed <= repetitions(50); ++seed) {
    std::mt19937 random(seed);
    // A grid of points shaken too little to fold a cell, some onto pixel centres, cut both ways.
    const int n = 9;
    const int cell = 900;
    std::vector<Snapped> grid;
    for (int j = 0; j < n; ++j) {
      for (int i = 0; i < n; ++i) {
        const bool rim = i == 0 || j == 0 || i == n - 1 || j == n - 1;
        Snapped p{i * cell, j * cell};
        if (!rim) {
          p.x += static_cast<int>(random() % 160) - 80;
          p.y += static_cast<int>(random() % 160) - 80;
        }
        if (!rim && random() % 3 == 0) p = {(p.x & ~255) | 128, (p.y & ~255) | 128};
        grid.push_back(p);
      }
    }
    std::vector<std::vector<Snapped>> triangles;
    for (int j = 0; j + 1 < n; ++j) {
      for (int i = 0; i + 1 < n; ++i) {
        const auto at = [&](int x, int y) { return grid[static_cast<std::size_t>(y * n + x)]; };
        const Snapped a = at(i, j), b = at(i + 1, j), c = at(i + 1, j + 1), e = at(i, j + 1);
        if (random() % 2 == 0) {
          triangles.push_back({a, b, c});
          triangles.push_back({c, a, e});
        } else {
          triangles.push_back({b, e, a});
          triangles.push_back({b, c, e});
        }
      }
    }
    const int side = (n - 1) * cell / 256;  // whole pixels inside the grid
    for (int covered : coverage(triangles, side, side)) {
      ASSERT_EQ(covered, 1) << "seed " << seed;
    }
  }
}

TEST(Outline, EqualsTheEdgeFunctionsAtEveryPixel) {
  for (unsigned seed = 1; seed <= repetitions(300); ++seed) {
    std::mt19937 random(seed);
    std::vector<Snapped> v(3);
    for (Snapped& p : v)
      p = {static_cast<int>(random() % 9000) - 2000, static_cast<int>(random() % 9000) - 2000};
    const Outline outline(v);
    std::int64_t area = 0;
    for (std::size_t i = 0; i < 3; ++i)
      area += v[i].x * v[(i + 1) % 3].y - v[i].y * v[(i + 1) % 3].x;
    if (area < 0) std::swap(v[0], v[1]);
    for (int y = 0; y < 24; ++y) {
      for (int x = 0; x < 24; ++x) {
        bool in = area != 0;
        for (std::size_t i = 0; i < 3; ++i) {
          const Snapped& p = v[i];
          const Snapped& q = v[(i + 1) % 3];
          const std::int64_t e =
              (q.x - p.x) * (256 * y + 128 - p.y) - (q.y - p.y) * (256 * x + 128 - p.x);
          const bool top_left = q.y < p.y || (q.y == p.y && q.x > p.x);
          in = in && (e > 0 || (e == 0 && top_left));
        }
        ASSERT_EQ(outline.covers(x, y), in) << "seed " << seed << " at " << x << ' ' << y;
      }
    }
  }
}

TEST(Outline, ManyRowsAreThoseOneByOne) {
  std::mt19937 random(11);
  SCOPED_TRACE("seed 11");
  std::uniform_int_distribution<std::int64_t> near(-5000, 25000);
  std::uniform_int_distribution<std::int64_t> far(-(1 << 28), 1 << 28);
  std::uniform_int_distribution<int> rows(-9, 105);
  int covered = 0;
  for (int i = 0; i < 4000; ++i) {
    std::vector<Snapped> triangle(3);
    for (Snapped& p : triangle)
      p = i % 4 == 0 ? Snapped{far(random), far(random)} : Snapped{near(random), near(random)};
    if (i % 5 == 0) triangle[1].y = triangle[0].y;  // a horizontal edge
    const Outline outline(triangle);
    if (outline.empty()) continue;
    const int first = rows(random);
    const std::array<Span, 8> spans = outline.rows(first, 80, 90);
    for (int row = 0; row < 8; ++row) {
      const Span expected = first + row < 90 ? outline.row(first + row, 80) : Span{};
      ASSERT_EQ(spans[static_cast<std::size_t>(row)].begin, expected.begin) << i;
      ASSERT_EQ(spans[static_cast<std::size_t>(row)].end, expected.end) << i;
      covered += expected.end - expected.begin;
    }
  }
  EXPECT_GT(covered, 10000);
}

}  // namespace
}  // namespace wedgesim::model
