#include "functional/raster/clip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <set>
#include <tuple>

#include "base/error.h"
#include "base/limits.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

Window plain_window() {
  Camera camera;
  camera.eye = {0.0, 0.0, 0.0};
  camera.target = {0.0, 0.0, -1.0};
  camera.field_of_view_degrees = 60.0;
  camera.near_plane = 0.5;
  camera.far_plane = 100.0;
  return make_window(camera, 320, 200);
}

SnappedPoint at(int x, int y) { return {x, y, 0.0}; }

using Bits = std::set<std::tuple<double, double, double>>;

Bits bits_of(const std::vector<WindowPoint>& points) {
  Bits bits;
  for (const WindowPoint& p : points) bits.insert({p.x, p.y, p.z});
  return bits;
}

// Does a shared edge that crosses near plane and guard band get the same clip vertices in both of
// its polygons, whichever way round they name it?
TEST(Clip, SharedEdgesAreCutOnce) {
  Random random(21);
  const Window window = plain_window();
  int crossing = 0;
  for (int i = 0; i < 20000; ++i) {
    // Ends in front of and behind the near plane, and far enough aside to leave the guard band.
    const double wide = random.chance(0.5) ? 500.0 : 5.0;
    const glm::dvec3 a =
        random.in_box(glm::dvec3(-wide, -wide, -60.0), glm::dvec3(wide, wide, -0.6));
    const glm::dvec3 b = random.in_box(glm::dvec3(-wide, -wide, -3.0), glm::dvec3(wide, wide, 4.0));
    const glm::dvec3 c = random.in_box(glm::dvec3(-wide), glm::dvec3(wide, wide, 2.0));
    const glm::dvec3 d = random.in_box(glm::dvec3(-wide), glm::dvec3(wide, wide, 2.0));
    const std::array<glm::dvec3, 3> one{a, b, c};
    const std::array<glm::dvec3, 3> same_way{a, b, d};
    const std::array<glm::dvec3, 3> other_way{b, a, d};
    const Bits first = bits_of(clip_to_window(window, one));
    if (first.empty()) continue;
    // The points on the line of the edge: those that both polygons have.
    const Bits second = bits_of(clip_to_window(window, same_way));
    const Bits third = bits_of(clip_to_window(window, other_way));
    ASSERT_EQ(second, third) << "case " << i;
    if (second.empty()) continue;
    Bits shared;
    std::set_intersection(first.begin(), first.end(), second.begin(), second.end(),
                          std::inserter(shared, shared.end()));
    // What is left of the edge itself, as a polygon without extent would be cut.
    const std::array<glm::dvec3, 2> edge{a, b};
    const std::array<glm::dvec3, 3> flat{a, b, 0.5 * (edge[0] + edge[1])};
    const std::vector<WindowPoint> ends = clip_to_window(window, flat);
    if (ends.size() < 2) continue;
    ++crossing;
    ASSERT_GE(shared.size(), 2U) << "case " << i << ": the edge was cut differently";
  }
  EXPECT_GT(crossing, 2000);
}

TEST(Clip, WhatIsBehindTheEyeVanishes) {
  Random random(22);
  const Window window = plain_window();
  for (int i = 0; i < 1000; ++i) {
    std::vector<glm::dvec3> polygon;
    for (int k = 0; k < 4; ++k) {
      polygon.push_back(random.in_box(glm::dvec3(-9.0, -9.0, -0.49), glm::dvec3(9.0)));
    }
    ASSERT_TRUE(clip_to_window(window, polygon).empty()) << "case " << i;
  }
}

// Is everything that is left in front of the near plane and inside the guard band, and does what
// needs no clipping keep its vertices?
TEST(Clip, KeepsWhatIsVisible) {
  Random random(23);
  const Window window = plain_window();
  for (int i = 0; i < 5000; ++i) {
    const double wide = random.chance(0.5) ? 2000.0 : 3.0;
    std::vector<glm::dvec3> polygon;
    for (int k = 0; k < 3; ++k) {
      polygon.push_back(
          random.in_box(glm::dvec3(-wide, -wide, -300.0), glm::dvec3(wide, wide, 3.0)));
    }
    for (const WindowPoint& p : clip_to_window(window, polygon)) {
      ASSERT_GE(p.z, -1e-9);
      ASSERT_GE(p.x, -32768.0 - 1e-6);
      ASSERT_LE(p.x, 49152.0 + 1e-6);
      ASSERT_GE(p.y, -32768.0 - 1e-6);
      ASSERT_LE(p.y, 49152.0 + 1e-6);
    }
  }
  const std::array<glm::dvec3, 3> inside{glm::dvec3(-1, -1, -5), glm::dvec3(1, -1, -5),
                                         glm::dvec3(0, 1, -200)};  // beyond the far plane, too
  const std::vector<WindowPoint> points = clip_to_window(window, inside);
  ASSERT_EQ(points.size(), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec4 h = window.window_from_world * glm::dvec4(inside[i], 1.0);
    EXPECT_EQ(points[i], glm::dvec3(h) / h.w);
  }
  EXPECT_GT(points[2].z, 1.0);
}

// Is a cut at the near plane, or at the guard band, there, where the near plane is nearer to the
// eye than the corners' rounding?
TEST(Clip, CutsNearerThanTheirCornersRoundingAreExact) {
  Random random(25);
  constexpr double kOff = 0.5 / 256.0;  // snapping moves a point as far
  int points = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 one(1.0);
    Camera camera;
    // About an eye at 0 corners can be all but there.
    if (random.chance(0.5)) camera.eye = random.in_box(-one, one);
    camera.target = camera.eye + random.in_box(-one, one);
    camera.near_plane = std::ldexp(1.0, -random.whole(5, 50));
    camera.far_plane = 100.0;
    std::vector<glm::dvec3> triangle;
    for (int k = 0; k < 3; ++k) {
      triangle.push_back(random.in_box(-one, one) * std::ldexp(1.0, random.whole(-40, 25)));
    }
    for (const WindowPoint& p : clip_to_window(make_window(camera, 320, 200), triangle)) {
      ++points;
      ASSERT_GE(std::min(p.x, p.y), kGuardLow - kOff) << "case " << i;
      ASSERT_LE(std::max(p.x, p.y), kGuardHigh + kOff) << "case " << i;
      ASSERT_GE(p.z, 0.0) << "case " << i;
    }
  }
  EXPECT_GT(points, 20000);
}

TEST(Clip, SnapsToTheNearest256thOfAPixel) {
  const SnappedPoint p = snap(WindowPoint(10.5 + 0.4 / 256.0, -3.0 - 0.6 / 256.0, 0.25));
  EXPECT_EQ(p.x, 10 * 256 + 128);
  EXPECT_EQ(p.y, -3 * 256 - 1);
  EXPECT_EQ(p.z, 0.25);
}

TEST(Clip, OnlyNumbersOfTheGuardBandAreSnapped) {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  EXPECT_NO_THROW(snap(WindowPoint(-32768.0, 49152.0, 0.5)));
  for (const double bad : {nan, std::numeric_limits<double>::infinity(), -1e10}) {
    EXPECT_THROW(snap(WindowPoint(bad, 0.0, 0.5)), CheckError) << bad;
    EXPECT_THROW(snap(WindowPoint(0.0, bad, 0.5)), CheckError) << bad;
  }
}

// Is the area negative for an outline that is counter-clockwise as seen on the screen?
TEST(Clip, AreaSignTellsTheFacing) {
  const std::vector<SnappedPoint> counter_clockwise{at(0, 0), at(0, 256), at(256, 256), at(256, 0)};
  EXPECT_EQ(doubled_area(counter_clockwise), -2 * 256 * 256);
  const Window window = plain_window();
  const std::array<glm::dvec3, 3> facing{glm::dvec3(-1, -1, -5), glm::dvec3(1, -1, -5),
                                         glm::dvec3(0, 1, -5)};
  EXPECT_LT(doubled_area(snap(clip_to_window(window, facing))), 0);
  const std::array<glm::dvec3, 3> away{facing[0], facing[2], facing[1]};
  EXPECT_GT(doubled_area(snap(clip_to_window(window, away))), 0);
}

TEST(Clip, ConvexOutlines) {
  EXPECT_TRUE(is_convex(std::vector{at(0, 0), at(0, 9), at(9, 9), at(9, 0)}));
  EXPECT_TRUE(is_convex(std::vector{at(9, 0), at(9, 9), at(0, 9), at(0, 0)}));
  EXPECT_TRUE(is_convex(std::vector{at(0, 0), at(0, 9), at(9, 9), at(9, 5), at(9, 0)}));
  EXPECT_TRUE(is_convex(std::vector{at(0, 0), at(3, 0), at(7, 0), at(9, 0)}));
  EXPECT_TRUE(is_convex(std::vector{at(4, 4), at(4, 4), at(9, 4), at(9, 9)}));
}

TEST(Clip, OutlinesThatAreNotConvex) {
  EXPECT_FALSE(is_convex(std::vector{at(0, 0), at(9, 9), at(9, 0), at(0, 9)})) << "bowtie";
  EXPECT_FALSE(is_convex(std::vector{at(0, 0), at(9, 0), at(3, 3), at(0, 9)})) << "dart";
  EXPECT_FALSE(is_convex(std::vector{at(0, 0), at(9, 0), at(5, 0), at(5, 5)})) << "spike";
  // Turns one way only, but twice around.
  EXPECT_FALSE(is_convex(std::vector{at(0, -10), at(6, 8), at(-10, -3), at(10, -3), at(-6, 8)}))
      << "pentagram";
  EXPECT_FALSE(is_convex(
      std::vector{at(0, 0), at(9, 0), at(9, 9), at(0, 9), at(0, 0), at(9, 0), at(9, 9), at(0, 9)}))
      << "twice around";
}

// Parts of an outline that turned inwards: convex, none with equal corners, signed areas that add
// up to the outline's.
TEST(Clip, ConvexParts) {
  Random random(24);
  int split = 0;
  for (int i = 0; i < 5000; ++i) {
    std::vector<SnappedPoint> outline;
    const int corners = random.whole(3, 7);
    for (int k = 0; k < corners; ++k) {
      outline.push_back(at(random.whole(0, 9), random.whole(0, 9)));
      if (random.chance(0.2)) outline.push_back(outline.back());
    }
    const auto parts = convex_parts(outline);
    std::int64_t area = 0;
    for (const auto& part : parts) {
      ASSERT_TRUE(is_convex(part)) << "case " << i;
      area += doubled_area(part);
    }
    ASSERT_EQ(area, doubled_area(outline)) << "case " << i;
    if (parts.size() > 1) ++split;
  }
  EXPECT_GT(split, 1000);
  const std::vector<SnappedPoint> twice{at(0, 0), at(0, 0), at(0, 9), at(9, 9), at(9, 9), at(0, 0)};
  EXPECT_EQ(convex_parts(twice).front().size(), 3U) << "corners that fell together are one";
}

}  // namespace
}  // namespace wedgesim::functional
