#include "functional/raster/spans.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <vector>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kWidth = 40;
constexpr int kHeight = 30;
using Outline = std::vector<SnappedPoint>;
using Counts = std::array<int, kWidth * kHeight>;

void count_spans(const Outline& outline, Counts& counts, int y_begin = 0, int y_end = kHeight) {
  for_each_span(outline, kWidth, y_begin, y_end, [&](int y, int x0, int x1) {
    ASSERT_GE(x0, 0);
    ASSERT_LE(x1, kWidth);
    ASSERT_LT(x0, x1);
    ASSERT_GE(y, y_begin);
    ASSERT_LT(y, y_end);
    for (int x = x0; x < x1; ++x) ++counts[static_cast<std::size_t>(y * kWidth + x)];
  });
}

// The documented rule, pixel by pixel: in an outline that runs clockwise on the screen (y down)
// left edges go up and top edges go right.
bool brute_force_inside(const Outline& outline, int x, int y) {
  __extension__ using Wide = __int128;
  const std::int64_t area = doubled_area(outline);
  if (area == 0) return false;
  for (std::size_t i = 0; i < outline.size(); ++i) {
    SnappedPoint p = outline[i];
    SnappedPoint q = outline[(i + 1) % outline.size()];
    if (area < 0) std::swap(p, q);
    if (p.x == q.x && p.y == q.y) continue;
    const Wide edge =
        Wide{q.x - p.x} * (256 * y + 128 - p.y) - Wide{q.y - p.y} * (256 * x + 128 - p.x);
    const bool left_or_top = q.y < p.y || (q.y == p.y && q.x > p.x);
    if (edge < 0 || (edge == 0 && !left_or_top)) return false;
  }
  return true;
}

// A coordinate around the frame; often on a pixel centre.
int random_coordinate(Random& random, int pixels) {
  const int low = -6 * 256;
  const int high = (pixels + 6) * 256;
  if (random.chance(0.4)) return 256 * random.whole(-6, pixels + 5) + 128;
  return random.whole(low, high);
}

SnappedPoint random_point(Random& random) {
  return {random_coordinate(random, kWidth), random_coordinate(random, kHeight), 0.0};
}

// Left and top edges are inside, right and bottom ones are not.
TEST(Spans, TiesOnASquareOverPixelCentres) {
  const int low = 2 * 256 + 128;
  const int high = 5 * 256 + 128;
  Outline square{{low, low, 0}, {high, low, 0}, {high, high, 0}, {low, high, 0}};
  for (int way = 0; way < 2; ++way) {
    Counts counts{};
    count_spans(square, counts);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const bool inside = x >= 2 && x < 5 && y >= 2 && y < 5;
        EXPECT_EQ(counts[static_cast<std::size_t>(y * kWidth + x)], inside ? 1 : 0)
            << x << ' ' << y;
      }
    }
    std::reverse(square.begin(), square.end());
  }
}

TEST(Spans, AreaZeroCoversNothing) {
  Counts counts{};
  count_spans({{128, 128, 0}, {128 + 2560, 128, 0}, {128 + 512, 128, 0}}, counts);
  count_spans({{128, 128, 0}, {128, 128, 0}, {128, 128, 0}}, counts);
  count_spans({{0, 0, 0}, {2560, 2560, 0}, {0, 2560, 0}, {2560, 0, 0}}, counts);  // bowtie
  for (const int count : counts) ASSERT_EQ(count, 0);
}

TEST(Spans, TrianglesAsByBruteForce) {
  Random random(31);
  for (int i = 0; i < 20000; ++i) {
    const Outline triangle{random_point(random), random_point(random), random_point(random)};
    Counts counts{};
    count_spans(triangle, counts);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(counts[static_cast<std::size_t>(y * kWidth + x)],
                  brute_force_inside(triangle, x, y) ? 1 : 0)
            << "case " << i << ", pixel " << x << ' ' << y;
      }
    }
  }
}

// Convex polygons: the hull of random points, with corners repeated and points on sides.
TEST(Spans, PolygonsAsByBruteForce) {
  Random random(32);
  int polygons = 0;
  for (int i = 0; i < 5000; ++i) {
    const double cx = random.uniform(0.0, 256.0 * kWidth);
    const double cy = random.uniform(0.0, 256.0 * kHeight);
    const double rx = random.uniform(1.0, 256.0 * kWidth);
    const double ry = random.uniform(1.0, 256.0 * kHeight);
    Outline outline;
    const int corners = random.whole(3, 9);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * (k + random.uniform(0.0, 0.9)) / corners;
      SnappedPoint p{static_cast<int>(cx + rx * std::cos(angle)),
                     static_cast<int>(cy + ry * std::sin(angle)), 0.0};
      if (random.chance(0.3)) p.x = (p.x & ~255) + 128;
      if (random.chance(0.3)) p.y = (p.y & ~255) + 128;
      outline.push_back(p);
      if (random.chance(0.1)) outline.push_back(p);
    }
    if (random.chance(0.5)) std::reverse(outline.begin(), outline.end());
    if (!is_convex(outline)) continue;
    ++polygons;
    Counts counts{};
    const int split = random.whole(0, kHeight);  // in two parts, as a band at a time
    count_spans(outline, counts, 0, split);
    count_spans(outline, counts, split, kHeight);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(counts[static_cast<std::size_t>(y * kWidth + x)],
                  brute_force_inside(outline, x, y) ? 1 : 0)
            << "case " << i << ", pixel " << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(polygons, 2000);
}

// Vertices at the ends of the guard band: no product may overflow.
TEST(Spans, GuardBand) {
  const int low = -32768 * 256;
  const int high = 49152 * 256;
  Random random(33);
  for (int i = 0; i < 2000; ++i) {
    Outline triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.push_back(
          {random.whole(0, 1) != 0 ? (random.chance(0.5) ? low : high) : random.whole(low, high),
           random.whole(0, 1) != 0 ? (random.chance(0.5) ? low : high) : random.whole(low, high),
           0.0});
    }
    Counts counts{};
    count_spans(triangle, counts);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        ASSERT_EQ(counts[static_cast<std::size_t>(y * kWidth + x)],
                  brute_force_inside(triangle, x, y) ? 1 : 0)
            << "case " << i;
      }
    }
  }
}

// Does a mesh with shared vertices cover each pixel exactly once: no gaps, no doubles?
TEST(Spans, MeshesCoverEachPixelOnce) {
  Random random(34);
  for (int i = 0; i < 300; ++i) {
    const int columns = random.whole(1, 12);
    const int rows = random.whole(1, 12);
    const double cell_x = 256.0 * (kWidth + 20) / columns;
    const double cell_y = 256.0 * (kHeight + 20) / rows;
    Outline grid;
    for (int r = 0; r <= rows; ++r) {
      for (int c = 0; c <= columns; ++c) {
        // The border stays outside the frame: a border vertex moves by less than 10 pixels.
        const double jitter = 0.24;
        double x = (c + random.uniform(-jitter, jitter)) * cell_x - 2560.0;
        double y = (r + random.uniform(-jitter, jitter)) * cell_y - 2560.0;
        if (c == 0 || c == columns) x = c * cell_x - 2560.0;
        if (r == 0 || r == rows) y = r * cell_y - 2560.0;
        SnappedPoint p{static_cast<int>(x), static_cast<int>(y), 0.0};
        const bool inner = c > 0 && c < columns && r > 0 && r < rows;
        if (inner && random.chance(0.4)) p = {(p.x & ~255) + 128, (p.y & ~255) + 128, 0.0};
        grid.push_back(p);
      }
    }
    Counts counts{};
    for (int r = 0; r < rows; ++r) {
      for (int c = 0; c < columns; ++c) {
        const auto corner = [&](int dr, int dc) {
          return grid[static_cast<std::size_t>((r + dr) * (columns + 1) + c + dc)];
        };
        Outline one{corner(0, 0), corner(0, 1), corner(1, 1)};
        Outline two{corner(0, 0), corner(1, 1), corner(1, 0)};
        if (random.chance(0.5)) {
          one = {corner(0, 0), corner(0, 1), corner(1, 0)};
          two = {corner(0, 1), corner(1, 1), corner(1, 0)};
        }
        if (random.chance(0.5)) std::reverse(one.begin(), one.end());
        if (random.chance(0.5)) std::reverse(two.begin(), two.end());
        count_spans(one, counts);
        count_spans(two, counts);
      }
    }
    for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) {
      ASSERT_EQ(counts[pixel], 1) << "case " << i << ", pixel " << pixel % kWidth << ' '
                                  << pixel / kWidth;
    }
  }
}

// A fan around a pixel centre: which of its triangles gets the centre?
TEST(Spans, FanAroundAPixelCentre) {
  Random random(35);
  for (int i = 0; i < 2000; ++i) {
    const SnappedPoint middle{20 * 256 + 128, 15 * 256 + 128, 0.0};
    Outline ring;
    const int corners = random.whole(3, 12);
    for (int k = 0; k < corners; ++k) {
      const double angle = 2.0 * M_PI * (k + random.uniform(0.0, 0.5)) / corners;
      SnappedPoint p{middle.x + static_cast<int>(2000.0 * std::cos(angle)),
                     middle.y + static_cast<int>(2000.0 * std::sin(angle)), 0.0};
      if (random.chance(0.3)) p.x = (p.x & ~255) + 128;
      if (random.chance(0.3)) p.y = (p.y & ~255) + 128;
      ring.push_back(p);
    }
    Counts counts{};
    for (std::size_t k = 0; k < ring.size(); ++k) {
      count_spans({middle, ring[k], ring[(k + 1) % ring.size()]}, counts);
    }
    for (std::size_t pixel = 0; pixel < counts.size(); ++pixel) ASSERT_LE(counts[pixel], 1);
    ASSERT_EQ(counts[15 * kWidth + 20], 1) << "case " << i;
  }
}

}  // namespace
}  // namespace wedgesim::functional
