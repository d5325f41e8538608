#include "functional/reference/judge_coverage.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

#include "functional/light/coverage.h"
#include "functional/scene/across.h"
#include "model/count/contribution.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

struct Configuration {
  glm::dvec3 point, begin, end;
};

double judged(LightShape shape, const Configuration& c) {
  return judged_coverage(shape, RealVector(c.point), RealVector(c.begin), RealVector(c.end))
      .convert_to<double>();
}

bool may_cover(LightShape shape, const Configuration& c) {
  return CoverageFilter(shape, RealVector(c.point)).may_cover(c.begin, c.end);
}

// How near an edge comes to the light's centre.
double clearance(const glm::dvec3& begin, const glm::dvec3& end) {
  const glm::dvec3 along = end - begin;
  const double t = std::clamp(-glm::dot(begin, along) / glm::dot(along, along), 0.0, 1.0);
  return glm::length(begin + t * along);
}

// An edge in front of the light and a point that may be anywhere about, often in its penumbra.
Configuration random_configuration(Random& random, LightShape shape) {
  Configuration c;
  const auto caster = [&] {
    if (shape == LightShape::rectangle) return random.in_box({-3, -3, 0.5}, {3, 3, 4});
    return random.uniform(1.4, 4.0) * random.direction();
  };
  c.begin = caster();
  do {
    c.end = random.chance(0.5) ? caster() : c.begin + 0.7 * random.direction();
  } while (shape == LightShape::rectangle ? c.end.z < 0.1 : clearance(c.begin, c.end) < 1.3);
  if (random.chance(0.3)) {
    const double far = shape == LightShape::rectangle ? 8.0 : 6.0;
    do {
      c.point = random.in_box(glm::dvec3(-far), glm::dvec3(far));
    } while (glm::length(c.point) < 2.0);
    return c;
  }
  // On a ray from the light past the edge.
  const glm::dvec3 on_edge = c.begin + random.uniform(-0.2, 1.2) * (c.end - c.begin);
  const glm::dvec3 on_light =
      random.in_box({-1, -1, 0}, {1, 1, shape == LightShape::rectangle ? 0 : 1});
  c.point = on_light + random.uniform(1.5, 4.0) * (on_edge - on_light);
  if (glm::length(c.point) < 2.0) c.point *= 4.0;
  return c;
}

// Whether the segment from a point to a light point meets the quad {s·e : e on the edge, s ≥ 1}.
bool is_hidden(const Configuration& c, const glm::dvec3& light_point) {
  const glm::dvec3 way = light_point - c.point;
  const double det = glm::dot(-way, glm::cross(c.begin, c.end));
  if (det == 0.0) return false;
  const double t = glm::dot(c.point, glm::cross(c.begin, c.end)) / det;
  const double a = glm::dot(-way, glm::cross(c.point, c.end)) / det;
  const double b = glm::dot(-way, glm::cross(c.begin, c.point)) / det;
  return t > 0.0 && t < 1.0 && a >= 0.0 && b >= 0.0 && a + b >= 1.0;
}

constexpr int kSide = 300;  // of the grid of light points

double by_rays(LightShape shape, const Configuration& c) {
  glm::dvec3 u(1, 0, 0);
  glm::dvec3 v(0, 1, 0);
  if (shape == LightShape::sphere) {
    // The disc that the tangent cone cuts from the plane through the centre.
    const double distance = glm::length(c.point);
    const Across across(c.point / distance);
    const double radius = distance / std::sqrt(distance * distance - 1.0);
    u = radius * across.u;
    v = radius * across.v;
  } else if (c.point.z <= 0.0) {
    return 0.0;
  }
  std::size_t hidden = 0;
  std::size_t all = 0;
  for (int i = 0; i < kSide; ++i) {
    for (int j = 0; j < kSide; ++j) {
      const double x = (2.0 * i + 1.0) / kSide - 1.0;
      const double y = (2.0 * j + 1.0) / kSide - 1.0;
      if (shape == LightShape::sphere && x * x + y * y > 1.0) continue;
      ++all;
      if (is_hidden(c, x * u + y * v)) ++hidden;
    }
  }
  return static_cast<double>(hidden) / static_cast<double>(all);
}

class OfLight : public testing::TestWithParam<LightShape> {};
INSTANTIATE_TEST_SUITE_P(JudgedCoverage, OfLight,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

// Is it the share of the light's points that rays do not reach past the edge's shadow quad?
TEST_P(OfLight, IsWhatRaysFind) {
  Random random(20051);
  int partly = 0;
  double worst = 0.0;
  for (int i = 0; i < 400; ++i) {
    const Configuration c = random_configuration(random, GetParam());
    const double covered = judged(GetParam(), c);
    const double expected = by_rays(GetParam(), c);
    // A convex part of the light has an outline of at most 8; half a cell along it is unsure.
    ASSERT_NEAR(covered, expected, 2.5 / kSide) << i;
    worst = std::max(worst, std::abs(covered - expected));
    if (covered > 0.01) ++partly;
  }
  std::cout << partly << " partly covered, largest difference " << worst << '\n';
  EXPECT_GT(partly, 100);
}

// Does the renderer's own formula agree to what double can hold?
TEST_P(OfLight, AgreesWithDouble) {
  Random random(7);
  double worst = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Configuration c = random_configuration(random, GetParam());
    const double covered = judged(GetParam(), c);
    // Beyond a sphere the renderer's wedge, not its formula, says that nothing is covered.
    if (GetParam() == LightShape::sphere && covered == 0.0) continue;
    const double difference = std::abs(covered - coverage(GetParam(), c.point, c.begin, c.end));
    worst = std::max(worst, difference);
    ASSERT_LE(difference, 1e-11) << i;
  }
  std::cout << "largest difference " << worst << '\n';
}

// What the block's formula in double gives of a sphere.
double by_the_block(const Configuration& c) {
  const auto constant = [](double d) { return model::Row{0, 0, 0, d}; };
  const model::SphereTerms terms = model::sphere_terms(
      {constant(c.point.x), constant(c.point.y), constant(c.point.z), constant(1.0)}, c.begin,
      c.end);
  return model::coverage(terms, 0.0, 0.0, 0.0);
}

// Does the block's, too?
TEST(JudgedCoverage, AgreesWithTheBlocksDouble) {
  Random random(8);
  double worst = 0.0;
  for (int i = 0; i < 3000; ++i) {
    const Configuration c = random_configuration(random, LightShape::sphere);
    const double covered = judged(LightShape::sphere, c);
    if (covered == 0.0) continue;
    worst = std::max(worst, std::abs(covered - by_the_block(c)));
    ASSERT_LE(worst, 1e-11) << i;
  }
  std::cout << "largest difference " << worst << '\n';
}

// And does it keep its digits on edges whose ends are far apart?
TEST(JudgedCoverage, AgreesWithTheBlocksDoubleOnLongEdges) {
  for (const double ratio : {1e2, 1e4, 1e6, 1e8}) {
    const Configuration c{
        {0.4, -0.1, 6.0}, {-0.3, 0.2, 1.5}, {ratio, 0.35 * ratio, 1.5 + 0.8 * ratio}};
    const double covered = judged(LightShape::sphere, c);
    EXPECT_GT(covered, 0.1) << ratio;
    EXPECT_NEAR(by_the_block(c), covered, 1e-15) << ratio;
  }
}

// Are the parts of an edge its whole, to nearly 200 bits?
TEST_P(OfLight, AddsUpAlongAnEdge) {
  Random random(99);
  for (int i = 0; i < 200; ++i) {
    const Configuration c = random_configuration(random, GetParam());
    const RealVector p(c.point);
    const RealVector a(c.begin);
    const RealVector b(c.end);
    const RealVector middle = a + Real(0.3) * (b - a);
    const Real whole = judged_coverage(GetParam(), p, a, b);
    const Real parts =
        judged_coverage(GetParam(), p, a, middle) + judged_coverage(GetParam(), p, middle, b);
    ASSERT_LE(abs(Real(whole - parts)).convert_to<double>(), 1e-50) << i;
  }
}

// Does the quick test in double never hide a covered part, and hide most of the rest?
TEST_P(OfLight, FilterIsSafe) {
  Random random(3);
  int covered = 0;
  int rejected = 0;
  constexpr int kCases = 20000;
  for (int i = 0; i < kCases; ++i) {
    Configuration c = random_configuration(random, GetParam());
    if (random.chance(0.5)) c.end = c.begin + std::pow(10.0, random.uniform(-12, 0)) * c.end;
    const bool kept = may_cover(GetParam(), c);
    if (!kept) ++rejected;
    if (judged(GetParam(), c) > 0.0) {
      ++covered;
      ASSERT_TRUE(kept) << i;
    }
  }
  std::cout << covered << " covered, " << rejected << " rejected of " << kCases << '\n';
  EXPECT_GT(rejected, (kCases - covered) / 4);
  EXPECT_GT(covered, kCases / 20);
}

// A point 2 above the centre sees an edge at height 1 twice as large on the light.
Configuration seen_from_above(glm::dvec2 from, glm::dvec2 to) {
  return {{0, 0, 2}, {0.5 * from, 1}, {0.5 * to, 1}};
}

// Areas known in closed form: trapezoids, corners, halves; in all four directions.
TEST(JudgedCoverage, RectangleInClosedForm) {
  struct Known {
    glm::dvec2 from, to;
    double area;  // of 4
  };
  const Known cases[] = {
      {{0.5, -0.5}, {0.5, 0.5}, 0.75},      // rays through two corners
      {{0.5, -2.0}, {0.5, 2.0}, 1.0},       // u ≥ 1/2
      {{0.1, -0.05}, {0.1, 0.05}, 0.495},   // u ≥ 0.1 and |v| ≤ u/2
      {{1.0, 0.0}, {0.0, 1.0}, 0.5},        // cuts a corner off
      {{0.5, 0.0}, {0.0, 0.5}, 0.875},      // before a corner
      {{-1.0, 0.25}, {1.0, 0.25}, 1.5},     // two corners
      {{0.5, 0.5}, {-0.5, 0.5}, 0.75},      // the other way round
      {{-1.0, 0.0}, {1.0, 0.0}, 2.0},       // through the centre: half
      {{-3.0, -3.0}, {2.0, 2.0}, 2.0},      // the same along the diagonal
      {{0.2, 0.2}, {0.7, 0.7}, 0.0},        // away from the centre
      {{1.5, -9.0}, {1.5, 9.0}, 0.0},       // past the light
      {{0.0, 0.0}, {0.0, 1.0}, 0.5 + 0.5},  // from the centre: its ray goes along +u
      {{-1.0, 1.0}, {1.0, 1.0}, 0.0},       // along the light's side
  };
  for (const Known& known : cases) {
    glm::dvec2 from = known.from;
    glm::dvec2 to = known.to;
    const bool turns = known.from != glm::dvec2(0.0);
    for (int quarter = 0; quarter < (turns ? 4 : 1); ++quarter) {
      EXPECT_NEAR(judged(LightShape::rectangle, seen_from_above(from, to)), known.area / 4.0, 1e-16)
          << from.x << ' ' << from.y << " to " << to.x << ' ' << to.y;
      from = {-from.y, from.x};
      to = {-to.y, to.x};
    }
  }
}

// An edge that goes on behind the point: from (1/2, 0) to infinity along (3, 4).
TEST(JudgedCoverage, RectangleOfAnEdgePastThePoint) {
  EXPECT_NEAR(judged(LightShape::rectangle, {{0, 0, 2}, {0.25, 0, 1}, {0.5, 1, 3}}), 1.0 / 24.0,
              1e-16);
}

// A segment of the disc: an edge that passes at a share of its radius.
TEST(JudgedCoverage, SphereInClosedForm) {
  for (const double distance : {2.0, 5.0, 100.0}) {
    for (const double foot : {0.0, 0.1, 0.5, 0.99}) {
      // The point is on the z axis; the edge, at half the distance, seen at `foot`.
      const double z = 0.75 * distance;
      const double x = foot * (distance - z) / std::sqrt(distance * distance - 1.0);
      for (int quarter = 0; quarter < 4; ++quarter) {
        const double turn = 0.5 * M_PI * quarter;
        const auto turned = [&](double u, double v) {
          return glm::dvec3(u * std::cos(turn) - v * std::sin(turn),
                            u * std::sin(turn) + v * std::cos(turn), z);
        };
        const Configuration c{{0, 0, distance}, turned(x, -50.0), turned(x, 50.0)};
        const double expected = (std::acos(foot) - foot * std::sqrt(1.0 - foot * foot)) / M_PI;
        EXPECT_NEAR(judged(LightShape::sphere, c), expected, 1e-12) << distance << ' ' << foot;
      }
    }
  }
}

// Input that has no shape gives the numbers that the header says.
TEST(JudgedCoverage, DegenerateInput) {
  const glm::dvec3 a(0.3, -0.2, 2.0);
  const glm::dvec3 b(0.4, 0.6, 2.5);
  const glm::dvec3 below(0.5, 0.1, 6.0);
  const double large = 1e200;
  const double small = 1e-200;
  struct Case {
    const char* what;
    Configuration c;
  };
  const Case nothing[] = {
      {"no length", {below, a, a}},
      {"point at an end", {a, a, b}},
      {"point on the edge", {0.5 * (a + b), a, b}},
      {"point on its line", {a + 4.0 * (b - a), a, b}},
      {"edge along the view to the centre", {4.0 * a, a, 2.0 * a}},
      {"edge behind the point", {a, 2.0 * a, 3.0 * b}},
      {"all in one place", {a, a, a}},
      {"far past the light", {below, {large, 0, 2}, {large, large, 2}}},
  };
  for (const LightShape shape : {LightShape::rectangle, LightShape::sphere}) {
    for (const Case& known : nothing) {
      EXPECT_EQ(judged(shape, known.c), 0.0) << known.what;
    }
    for (const Configuration& c :
         {Configuration{below, large * a, b}, Configuration{large * below, a, b},
          Configuration{below, a, a + small * b}, Configuration{below, small * a, small * b},
          Configuration{glm::dvec3(0), a, b}, Configuration{glm::dvec3(1, 0, 0), a, b},
          Configuration{small * below, a, b}, Configuration{-below, a, b},
          Configuration{below, glm::dvec3(0), b}, Configuration{below, -a, a},
          Configuration{below, below, -below}}) {
      const double covered = judged(shape, c);
      EXPECT_TRUE(covered >= 0.0 && covered <= 0.5) << covered;
      may_cover(shape, c);
    }
  }
  EXPECT_EQ(judged(LightShape::rectangle, {{0.2, 0.1, 0.0}, a, b}), 0.0);
  EXPECT_EQ(judged(LightShape::rectangle, {{0.2, 0.1, -3.0}, a, b}), 0.0);
  EXPECT_EQ(judged(LightShape::sphere, {{0.6, 0.1, 0.1}, a, b}), 0.0);
  EXPECT_EQ(judged(LightShape::sphere, {{0.0, 1.0, 0.0}, a, b}), 0.0);
  // An edge beyond the sphere hides nothing of it.
  EXPECT_EQ(judged(LightShape::sphere, {{0, 0, 5}, {0.1, -1, -3}, {0.1, 1, -3}}), 0.0);
  EXPECT_EQ(judged(LightShape::point, {below, a, b}), 0.0);
}

}  // namespace
}  // namespace wedgesim::functional
