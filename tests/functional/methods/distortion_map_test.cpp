// The nearest silhouette at every texel, against the distance to every strip.
#include "functional/methods/distortion_map.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <vector>

namespace wedgesim::functional {
namespace {

constexpr int kSize = 96;
constexpr float kWidth = 11.0F;  // texels of every penumbra, to either side

// A closed polygon with the caster on its left in the world, y up: clockwise on the screen, y down,
// is (x, y) → angle growing.
std::vector<PenumbraStrip> polygon(const std::vector<glm::vec2>& corners) {
  std::vector<PenumbraStrip> strips;
  const std::size_t n = corners.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::vec2 way = corners[(i + 1) % n] - corners[i];
    PenumbraStrip strip;
    strip.begin = corners[i];
    strip.length = glm::length(way);
    strip.along = way / strip.length;
    strip.near_begin = strip.near_end = 1.0F;
    strip.far = 2.0F;
    strip.scale = 2.0F * kWidth;
    strip.previous = static_cast<std::uint32_t>((i + n - 1) % n);
    strips.push_back(strip);
  }
  return strips;
}

// A star: turns both ways.
std::vector<glm::vec2> star() {
  std::vector<glm::vec2> corners;
  for (int i = 0; i < 10; ++i) {
    const double angle = -i * M_PI / 5.0 + 0.1;
    const double radius = i % 2 == 0 ? 36.0 : 20.0;
    corners.emplace_back(48.3 + radius * std::cos(angle), 47.9 + radius * std::sin(angle));
  }
  return corners;
}

float distance_to(const PenumbraStrip& strip, const glm::vec2& p) {
  const float along = std::clamp(glm::dot(p - strip.begin, strip.along), 0.0F, strip.length);
  return glm::distance(p, strip.begin + along * strip.along);
}

bool is_inside(const std::vector<glm::vec2>& corners, const glm::vec2& p) {
  bool inside = false;
  for (std::size_t i = 0, j = corners.size() - 1; i < corners.size(); j = i++) {
    const glm::vec2& a = corners[i];
    const glm::vec2& b = corners[j];
    if ((a.y > p.y) != (b.y > p.y) && p.x < (b.x - a.x) * (p.y - a.y) / (b.y - a.y) + a.x) {
      inside = !inside;
    }
  }
  return inside;
}

class Star : public testing::TestWithParam<int> {};
INSTANTIATE_TEST_SUITE_P(Maps, Star, testing::Values(1, 2));

TEST_P(Star, EveryTexelOfThePenumbraNamesItsNearestEdge) {
  const std::vector<glm::vec2> corners = star();
  const std::vector<PenumbraStrip> strips = polygon(corners);
  const DistortionMap map(strips, kSize, GetParam());
  std::size_t held = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const glm::vec2 p(static_cast<float>(x) + 0.5F, static_cast<float>(y) + 0.5F);
      float nearest = 1e30F;
      for (const PenumbraStrip& strip : strips) nearest = std::min(nearest, distance_to(strip, p));
      const bool inside = is_inside(corners, p);
      const StripName name = map.at(inside, x, y);
      if (nearest > kWidth - 0.01F || nearest < 0.01F) continue;
      ASSERT_TRUE(name.exists()) << x << " " << y;
      EXPECT_TRUE(map.holds(x, y));
      EXPECT_NEAR(distance_to(strips[name.strip()], p), nearest, 1e-3F) << x << " " << y;
      EXPECT_NE(name.part(),
                inside ? StripName::Part::outer_corner : StripName::Part::inner_corner);
      ++held;
    }
  }
  EXPECT_GT(held, 2500U);
}

TEST(DistortionMap, TwoMapsKeepTheSidesApart) {
  const std::vector<glm::vec2> corners = star();
  const DistortionMap map(polygon(corners), kSize, 2);
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      if (!map.at(true, x, y).exists()) continue;
      EXPECT_NE(map.at(true, x, y).part(), StripName::Part::outer_corner);
    }
  }
  EXPECT_FALSE(map.at(false, 48, 48).exists());
  EXPECT_FALSE(map.at(true, 1, 48).exists());
}

TEST(DistortionMap, HoldsNothingFarFromAPenumbra) {
  const DistortionMap map(polygon({{20.0F, 20.0F}, {20.0F, 24.0F}, {24.0F, 22.0F}}), kSize, 2);
  EXPECT_TRUE(map.holds(22, 22));
  EXPECT_FALSE(map.holds(80, 80));
  EXPECT_FALSE(map.at(false, 80, 80).exists());
  EXPECT_LE(map.written(), map.compared());
  EXPECT_GT(map.written(), 100U);
}

}  // namespace
}  // namespace wedgesim::functional
