#include "functional/light/light_samples.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <set>

namespace wedgesim::functional {
namespace {

constexpr std::array kPatterns{SamplePattern::random, SamplePattern::grid, SamplePattern::border};

TEST(SquareSamples, OneIsInTheMiddle) {
  for (const SamplePattern pattern : kPatterns) {
    EXPECT_EQ(square_samples(1, pattern), std::vector{glm::dvec2(0.0)});
  }
}

TEST(SquareSamples, AreInTheSquareAndAsManyAsAskedFor) {
  for (const SamplePattern pattern : kPatterns) {
    for (int count = 1; count <= 64; ++count) {
      const auto points = square_samples(count, pattern);
      const int side = static_cast<int>(std::sqrt(count + 0.5));
      EXPECT_EQ(points.size(), pattern == SamplePattern::grid ? side * side : count) << count;
      for (const glm::dvec2& p : points) {
        EXPECT_LE(std::max(std::abs(p.x), std::abs(p.y)), 1.0) << count;
      }
      EXPECT_EQ(points, square_samples(count, pattern)) << "the same every time";
    }
  }
}

TEST(SquareSamples, OfRandomOnesNoTwoAreInLineWithASide) {
  for (const int count : {2, 3, 9, 25, 64}) {
    std::set<double> columns;
    std::set<double> rows;
    for (const glm::dvec2& p : square_samples(count, SamplePattern::random)) {
      EXPECT_TRUE(columns.insert(p.x).second);
      EXPECT_TRUE(rows.insert(p.y).second);
    }
    EXPECT_EQ(*columns.begin(), -1.0) << "the border is reached";
    EXPECT_EQ(*columns.rbegin(), 1.0);
    EXPECT_EQ(*rows.begin(), -1.0);
    EXPECT_EQ(*rows.rbegin(), 1.0);
  }
}

TEST(SquareSamples, ThoseOfTheBorderAreOnIt) {
  for (const glm::dvec2& p : square_samples(20, SamplePattern::border)) {
    EXPECT_EQ(std::max(std::abs(p.x), std::abs(p.y)), 1.0);
  }
}

TEST(LightSamples, LieInTheRectangle) {
  Light light;
  light.centre = {1, 5, 2};
  light.half_u = {2, 0, 0};
  light.half_v = {0, 0, 0.5};
  for (const glm::dvec3& p : light_samples(light, 9, SamplePattern::random, glm::dvec3(0.0))) {
    EXPECT_LE(std::abs(p.x - 1.0), 2.0);
    EXPECT_DOUBLE_EQ(p.y, 5.0);
    EXPECT_LE(std::abs(p.z - 2.0), 0.5);
  }
}

// The cone from the point that touches the sphere passes through the rim of the disc.
TEST(LightSamples, OfASphereLieInTheDiscThatIsSeen) {
  Light light;
  light.shape = LightShape::sphere;
  light.centre = {0, 5, 0};
  light.radius = 3.0;
  const glm::dvec3 eye(0.0);
  double widest = 0.0;
  for (const glm::dvec3& p : light_samples(light, 16, SamplePattern::border, eye)) {
    EXPECT_NEAR(p.y, 5.0, 1e-12);
    widest = std::max(widest, glm::distance(p, light.centre));
    // The distance of the ray from the centre.
    EXPECT_NEAR(glm::length(glm::cross(light.centre - eye, glm::normalize(p - eye))), 3.0, 1e-12);
  }
  EXPECT_GT(widest, 3.0);
}

TEST(LightSamples, OfALightWithoutExtentAreItsCentre) {
  Light light;
  light.shape = LightShape::point;
  light.centre = {1, 2, 3};
  EXPECT_EQ(light_samples(light, 9, SamplePattern::random, glm::dvec3(0.0)),
            std::vector{light.centre});
}

}  // namespace
}  // namespace wedgesim::functional
