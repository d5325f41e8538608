#include "functional/light/shader_tables.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <iostream>
#include <numbers>

#include "functional/light/coverage.h"
#include "functional/light/emission.h"
#include "tests/functional/light/chords.h"

namespace wedgesim::functional {
namespace {

TEST(AngleMap, IsWithinHalfATexelAllTheWayRound) {
  const AngleMap map;
  double worst = 0.0;
  for (int i = 0; i < 10000; ++i) {
    const double angle = std::numbers::pi * (i + 0.5) / 5000.0 - std::numbers::pi;
    const glm::vec2 direction(3.0 * std::cos(angle), 3.0 * std::sin(angle));
    worst = std::max(worst, std::abs(static_cast<double>(map.angle(direction)) - angle));
  }
  std::cout << "largest error " << worst << " radian\n";
  EXPECT_LE(worst, 1.0 / 128.0 + 1e-4);
  EXPECT_GT(worst, 0.5 / 128.0);
  EXPECT_EQ(AngleMap::kBytes, 192U * 1024U);
}

// The paper gives 324 KB and about 270 KB in all, with the map of angles and 4 KB of split words.
TEST(SectorTable, HasTheSizesOfThePaper) {
  constexpr std::size_t kSplit = 1024 * 4;
  EXPECT_EQ(SectorTable::disc().bytes() + AngleMap::kBytes + kSplit, 324U * 1024U);
  EXPECT_EQ(SectorTable::square().bytes() + AngleMap::kBytes + kSplit, 260U * 1024U);
}

struct Error {
  double worst = 0.0;
  double squares = 0.0;
  int count = 0;
  void take(double is, double exact) {
    worst = std::max(worst, std::abs(is - exact));
    squares += (is - exact) * (is - exact);
    ++count;
  }
  double rms() const { return std::sqrt(squares / count); }
  void print(const char* what) const {
    std::cout << what << ": largest error " << worst << ", RMS " << rms() << '\n';
  }
};

// Angles within 1/128 radian move the sector by at most 2/128 of π/2 and of 4.
TEST(SectorTable, OfASquareIsTheCoverageOfARectangle) {
  Random random(11);
  const SectorTable table = SectorTable::square();
  const Emission exact;
  Error error;
  for (int i = 0; i < 20000; ++i) {
    const RandomChord chord = random_chord(random);
    const float is = table.coverage(glm::vec2(chord.p), glm::vec2(chord.q));
    error.take(is, exact.beyond(chord.p, chord.q)[0]);
  }
  error.print("square");
  EXPECT_LT(error.worst, 0.01);
  EXPECT_LT(error.rms(), 0.002);
}

TEST(SectorTable, OfADiscIsTheSegmentBeyondTheChord) {
  Random random(12);
  const SectorTable table = SectorTable::disc();
  Error error;
  for (int i = 0; i < 20000; ++i) {
    const auto end = [&] {
      const double angle = random.uniform(-std::numbers::pi, std::numbers::pi);
      const double radius = random.chance(0.3) ? random.uniform(0.0, 1.0) : 1.0;
      return radius * glm::dvec2(std::cos(angle), std::sin(angle));
    };
    const glm::dvec2 p = end();
    const glm::dvec2 q = end();
    const double cross = p.x * q.y - p.y * q.x;
    const double angle = std::abs(std::atan2(cross, glm::dot(p, q)));
    error.take(table.coverage(glm::vec2(p), glm::vec2(q)),
               (angle - std::abs(cross)) / (2.0 * std::numbers::pi));
  }
  error.print("disc");
  EXPECT_LT(error.worst, 2.0 / 128.0 / (2.0 * std::numbers::pi) + 1e-4);
  EXPECT_LT(error.rms(), 0.0012);
}

TEST(ShaderCoverage, OfARectangleIsNearTheExact) {
  Random random(13);
  const SectorTable table = SectorTable::square();
  Error error;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 point = random.in_box({-3, -3, 9}, {3, 3, 11});
    const glm::dvec3 begin = random.in_box({-3, -3, 2}, {3, 3, 8});
    const glm::dvec3 end = random.in_box({-3, -3, 2}, {3, 3, 8});
    const double exact = rectangle_coverage(point, begin, end);
    if (exact == 0.0) continue;
    error.take(shader_rectangle_coverage(table, point, begin, end), exact);
  }
  error.print("rectangle");
  EXPECT_GT(error.count, 3000);
  EXPECT_LT(error.worst, 0.01);
  EXPECT_LT(error.rms(), 0.002);
}

// Far from the sphere the cone through its disc is the tangent cone but for 1 / (2 d²).
TEST(ShaderCoverage, OfASphereIsNearTheExactWhereItIsFar) {
  Random random(14);
  const SectorTable table = SectorTable::disc();
  for (const double distance : {4.0, 30.0}) {
    Error error;
    for (int i = 0; i < 40000; ++i) {
      const glm::dvec3 way = random.direction();
      const glm::dvec3 point = distance * way;
      const auto end = [&] {
        return random.uniform(0.3, 1.5) * point +
               0.9 * random.in_box(glm::dvec3(-1), glm::dvec3(1));
      };
      const glm::dvec3 begin = end();
      const glm::dvec3 last = end();
      if (glm::length(begin) < 1.0 || glm::length(last) < 1.0) continue;
      const double exact = sphere_coverage(point, begin, last);
      const float is = shader_sphere_coverage(table, point, begin, last);
      if (exact > 0.0 || is > 0.0F) error.take(is, exact);
    }
    error.print(distance > 10.0 ? "sphere, far" : "sphere, near");
    EXPECT_GT(error.count, 1000);
    EXPECT_LT(error.rms(), distance > 10.0 ? 0.002 : 0.02);
    EXPECT_GT(error.rms(), distance > 10.0 ? 0.0 : 0.002) << "the disc is not the tangent cone";
  }
}

TEST(SplitCoverage, HasElevenBits) {
  for (int i = 0; i <= 1000; ++i) {
    const float coverage = static_cast<float>(i) / 2000.0F;
    const double is = static_cast<double>(split_coverage(coverage).unpack()) / SplitWord::kWhole;
    ASSERT_NEAR(is, coverage, 0.5 / 2046.0 + 0.5 / 4095.0 + 1e-6);
  }
  EXPECT_EQ(split_coverage(0.7F).components, split_coverage(0.5F).components);
}

}  // namespace
}  // namespace wedgesim::functional
