#include "model/count/contribution.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <random>

#include "model/count/atan.h"
#include "model/datapath/disc_frame.h"
#include "traces/trace.h"

namespace wedgesim::model {
namespace {

constexpr double kTau = 2.0 * kPi;

TEST(UpperAngle, IsWithin1e12OfTheAngle) {
  for (int i = 0; i <= 200000; ++i) {
    const double angle = kPi * i / 200000;
    const double r = std::ldexp(1.0, i % 40 - 20);
    const double y = r * std::fabs(std::sin(angle));
    const double x = r * std::cos(angle);
    ASSERT_NEAR(upper_angle(y, x), std::atan2(y, x), 1e-12) << angle;
  }
  EXPECT_EQ(upper_angle(0.0, 0.0), 0.0);
  EXPECT_DOUBLE_EQ(upper_angle(0.0, -2.0), kPi);
  EXPECT_DOUBLE_EQ(upper_angle(3.0, 0.0), kHalfPi);
}

TEST(UpperAngle, IsWithin4e7OfTheAngleInSinglePrecision) {
  double worst = 0.0;
  for (int i = 0; i <= 200000; ++i) {
    const double angle = kPi * i / 200000;
    const auto y = static_cast<float>(std::fabs(std::sin(angle)));
    const auto x = static_cast<float>(std::cos(angle));
    const double error = static_cast<double>(upper_angle(y, x)) -
                         std::atan2(static_cast<double>(y), static_cast<double>(x));
    worst = std::max(worst, std::fabs(error));
  }
  EXPECT_LE(worst, 4e-7);
  EXPECT_GE(worst, 1e-7) << "not in single precision";
}

TEST(ToWord, RoundsToNearestTiesToEven) {
  EXPECT_EQ(to_word(1.0, 255.0), 255);
  EXPECT_EQ(to_word(0.5 / 255.0, 255.0), 0);
  EXPECT_EQ(to_word(1.5 / 255.0, 255.0), 2);
  EXPECT_EQ(to_word(0.25, word_one(DatapathKind::exact)), std::int64_t{1} << 38);
}

// Terms at the point (0, 0, 0) of window space, so that only the constants of rows count.
RectangleTerms rectangle_at(const glm::dvec3& p, const glm::dvec3& begin, const glm::dvec3& end) {
  const auto constant = [](double d) { return Row{0, 0, 0, d}; };
  const auto project = [&](const glm::dvec3& e) {
    return RectangleTerms::End{constant(p.z * e.x - e.z * p.x), constant(p.z * e.y - e.z * p.y),
                               constant(p.z - e.z)};
  };
  return {{project(begin), project(end)}};
}

SphereTerms sphere_at(const glm::dvec3& p, double w, const glm::dvec3& begin,
                      const glm::dvec3& end) {
  const auto constant = [](double d) { return Row{0, 0, 0, d}; };
  return sphere_terms({constant(w * p.x), constant(w * p.y), constant(w * p.z), constant(w)}, begin,
                      end);
}

// The part of a polygon on one side of the line through p with normal n.
std::vector<glm::dvec2> cut(const std::vector<glm::dvec2>& polygon, glm::dvec2 p, glm::dvec2 n) {
  std::vector<glm::dvec2> kept;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const glm::dvec2 a = polygon[i];
    const glm::dvec2 b = polygon[(i + 1) % polygon.size()];
    const double fa = glm::dot(a - p, n);
    const double fb = glm::dot(b - p, n);
    if (fa >= 0) kept.push_back(a);
    if ((fa < 0) != (fb < 0)) kept.push_back(a + (b - a) * (fa / (fa - fb)));
  }
  return kept;
}

double cross2(glm::dvec2 a, glm::dvec2 b) { return a.x * b.y - a.y * b.x; }

double area(const std::vector<glm::dvec2>& polygon) {
  double sum = 0.0;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    sum += cross2(polygon[i], polygon[(i + 1) % polygon.size()]);
  }
  return 0.5 * sum;
}

// The area fraction of a convex outline about the origin that is seen through the segment a-b from
// the origin, beyond the segment: in the wedge between the rays through a and b, past the line.
double hidden(const std::vector<glm::dvec2>& outline, glm::dvec2 a, glm::dvec2 b) {
  if (cross2(a, b) < 0.0) std::swap(a, b);
  const glm::dvec2 past(b.y - a.y, a.x - b.x);  // away from the origin
  auto part = cut(outline, {0, 0}, {-a.y, a.x});
  part = cut(part, {0, 0}, {b.y, -b.x});
  part = cut(part, a, past);
  return part.size() < 3 ? 0.0 : area(part) / area(outline);
}

// Clips the segment a-b to a convex outline, counter-clockwise; false if nothing is left.
bool clip_segment(const std::vector<glm::dvec2>& outline, glm::dvec2& a, glm::dvec2& b) {
  for (std::size_t i = 0; i < outline.size(); ++i) {
    const glm::dvec2 p = outline[i];
    const glm::dvec2 q = outline[(i + 1) % outline.size()];
    const double fa = cross2(q - p, a - p);
    const double fb = cross2(q - p, b - p);
    if (fa < 0 && fb < 0) return false;
    if (fa < 0) a = a + (b - a) * (fa / (fa - fb));
    if (fb < 0) b = b + (a - b) * (fb / (fb - fa));
  }
  return true;
}

TEST(RectangleCoverage, EqualsTheClippedPolygon) {
  const std::vector<glm::dvec2> square{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}};
  std::mt19937 random(11);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int partial = 0;
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 p(3.0 * unit(random), 3.0 * unit(random), 6.0 + unit(random));
    const auto edge_end = [&] {
      return glm::dvec3(2.0 * unit(random), 2.0 * unit(random), 2.5 + 2.0 * unit(random));
    };
    const glm::dvec3 begin = edge_end();
    const glm::dvec3 end = edge_end();
    const double actual = coverage(rectangle_at(p, begin, end), 0, 0, 0);
    const auto project = [&](const glm::dvec3& e) {
      const double t = p.z / (p.z - e.z);
      return glm::dvec2(p.x + t * (e.x - p.x), p.y + t * (e.y - p.y));
    };
    glm::dvec2 a = project(begin);
    glm::dvec2 b = project(end);
    const double expected = clip_segment(square, a, b) ? hidden(square, a, b) : 0.0;
    ASSERT_NEAR(actual, expected, 1e-9) << i;
    partial += expected > 0.01 ? 1 : 0;
  }
  EXPECT_GT(partial, 2000);
}

TEST(RectangleCoverage, AnEdgeAcrossTheMiddleHidesHalf) {
  const glm::dvec3 p(0, 0, 4);
  EXPECT_NEAR(coverage(rectangle_at(p, {-3, 1e-9, 2}, {3, 1e-9, 2}), 0, 0, 0), 0.5, 1e-8);
  EXPECT_EQ(coverage(rectangle_at(p, {-3, 2, 2}, {3, 2, 2}), 0, 0, 0), 0.0);
  // An edge that ends in the centre itself: no direction, no area.
  EXPECT_EQ(coverage(rectangle_at(p, {0, 0, 2}, {0, 0, 2}), 0, 0, 0), 0.0);
}

TEST(RectangleCoverage, IsNothingOnTheLightsPlane) {
  // Point and edge at the same height: the projection is at infinity.
  EXPECT_EQ(coverage(rectangle_at({1, 1, 2}, {-3, 1, 2}, {3, 1, 2}), 0, 0, 0), 0.0);
}

TEST(SphereCoverage, EqualsAFinePolygon) {
  std::vector<glm::dvec2> disc;
  constexpr int kSides = 20000;
  for (int i = 0; i < kSides; ++i) {
    const double angle = kTau * i / kSides;
    disc.emplace_back(std::cos(angle), std::sin(angle));
  }
  std::mt19937 random(12);
  std::uniform_real_distribution<double> unit(-1.0, 1.0);
  int partial = 0;
  for (int i = 0; i < 300; ++i) {
    const glm::dvec3 p(2.0 * unit(random), 2.0 * unit(random), 4.0 + 2.0 * unit(random));
    const double reach = 0.3 + 0.3 * unit(random);
    const auto edge_end = [&] {
      return p * reach + 0.9 * glm::dvec3(unit(random), unit(random), unit(random));
    };
    const glm::dvec3 begin = edge_end();
    const glm::dvec3 end = edge_end();
    const double actual = coverage(sphere_at(p, 0.5 + reach, begin, end), 0, 0, 0);
    // The disc in which the tangent cone from p touches; ends as seen from p on its plane.
    const double distance = glm::length(p);
    const glm::dvec3 axis = -p / distance;
    const glm::dvec3 u = glm::normalize(glm::cross(axis, glm::dvec3(1, 0.3, 0.1)));
    const glm::dvec3 v = glm::cross(axis, u);
    const double tangent = 1.0 / std::sqrt(distance * distance - 1.0);
    const auto project = [&](const glm::dvec3& e) {
      const glm::dvec3 to = e - p;
      const double axial = glm::dot(to, axis) * tangent;
      return glm::dvec2(glm::dot(to, u) / axial, glm::dot(to, v) / axial);
    };
    if (glm::dot(begin - p, axis) <= 0.05 || glm::dot(end - p, axis) <= 0.05) continue;
    glm::dvec2 a = project(begin);
    glm::dvec2 b = project(end);
    const double expected = clip_segment(disc, a, b) ? hidden(disc, a, b) : 0.0;
    ASSERT_NEAR(actual, expected, 1e-6) << i;
    partial += expected > 0.01 ? 1 : 0;
  }
  EXPECT_GT(partial, 50);
}

TEST(SphereCoverage, LooksOnlyTowardsTheLight) {
  // An edge behind the point is on the cone's other half.
  EXPECT_EQ(coverage(sphere_at({0, 0, 4}, 1, {-1, 0.1, 6}, {1, 0.1, 6}), 0, 0, 0), 0.0);
  EXPECT_NEAR(coverage(sphere_at({0, 0, 4}, 1, {-2, 1e-9, 2}, {2, 1e-9, 2}), 0, 0, 0), 0.5, 1e-8);
  // From one side of the point to the other: the half towards the light counts.
  EXPECT_GT(coverage(sphere_at({0, 0, 4}, 1, {0.1, 0.05, 2}, {-0.3, 0.2, 7}), 0, 0, 0), 0.0);
  // Inside the light nothing is hidden.
  EXPECT_EQ(coverage(sphere_at({0, 0, 0.5}, 1, {-2, 0.1, 0.4}, {2, 0.1, 0.4}), 0, 0, 0), 0.0);
}

// An edge that all but points at the light's centre: what is left along its line in the way out to
// the line, as small as rounding, would be multiplied by the point's distance.
TEST(SphereCoverage, KeepsItsDigitsOnEdgesThatPointAtTheLight) {
  const glm::dvec3 begin(-0x1p-17, -4.5, 0.0), end(-0x1p-17, -4.3125, -0x1p-17);
  const datapath::DiscFrame frame = datapath::disc_frame(begin, end);
  EXPECT_LT(frame.distance, 1e-3);
  EXPECT_NEAR(glm::dot(frame.out, frame.along), 0.0, 1e-16);
}

// A light, and a wedge under it, whose points in light space are those of a matrix.
class SinglePrecision : public testing::Test {
 protected:
  // The light's coordinates of window points: to about the light, w about 1, and the part of z
  // that `offset` times a depth of 0.5 takes away again.
  void set_matrix(double offset) {
    std::array<double, 16> m{0.01,   0.002, 0.003,        0.0, -0.003, 0.02, 0.001, 0.0,
                             offset, -0.4,  2.0 - offset, 0.1, -1.0,   -0.5, 2.5,   1.0};
    depth_range_ = std::min(1e-3, 1.0 / offset);
    m[12] -= 0.5 * offset;
    m[14] += 0.5 * offset;
    trace_.header.lights.resize(1);
    trace_.header.lights[0].light_from_window =
        traces::fb::Matrix4(flatbuffers::span<const double, 16>(m));
  }
  // The largest difference between both precisions at random points, under random edges.
  double worst(traces::fb::LightShape shape) {
    trace_.header.lights[0].shape = shape;
    std::mt19937 random(13);
    const auto uniform = [&](double low, double high) {
      return low + (high - low) * (static_cast<double>(random()) * 0x1p-32);
    };
    double worst = 0.0;
    partial_ = 0;
    for (int i = 0; i < 20000; ++i) {
      traces::fb::Wedge wedge;
      wedge.mutate_kind(traces::fb::WedgeKind_coverage);
      wedge.mutable_edge_begin() = {uniform(-1, 1), uniform(-1, 1), uniform(1.1, 2.0)};
      wedge.mutable_edge_end() = {uniform(-1, 1), uniform(-1, 1), uniform(1.1, 2.0)};
      const double x = std::floor(uniform(20, 130)) + 0.5, y = std::floor(uniform(0, 90)) + 0.5;
      const double z =
          static_cast<double>(static_cast<float>(uniform(0.5 - depth_range_, 0.5 + depth_range_)));
      const double real = contribution(light_terms(trace_.view(), wedge), x, y, z);
      const double single = contribution(single_terms(trace_.view(), wedge), x, y, z);
      partial_ += real > 0.01 ? 1 : 0;
      worst = std::max(worst, std::fabs(single - real));
    }
    return worst;
  }

  traces::Trace trace_;
  double depth_range_ = 0.0;  // on either side of 0.5
  int partial_ = 0;           // points that see a part
};

TEST_F(SinglePrecision, EveryOperatorOfAPlaneRounds) {
  std::mt19937 random(14);
  std::uniform_real_distribution<float> unit(-1.0F, 1.0F);
  int differing = 0;
  for (int i = 0; i < 1000; ++i) {
    const volatile float a = unit(random), b = unit(random), c = unit(random), d = unit(random);
    const volatile float x = 100.0F * unit(random), y = 100.0F * unit(random), z = unit(random);
    const volatile float ax = a * x, by = b * y, cz = c * z;
    const volatile float ab = ax + by;
    const volatile float abc = ab + cz;
    const volatile float value = abc + d;
    const Plane plane{double{a}, double{b}, double{c}, double{d}};
    const double single = single_plane(plane).value(double{x}, double{y}, double{z});
    ASSERT_EQ(single, double{value}) << i;
    differing += single != static_cast<double>(
                               static_cast<float>(plane.value(double{x}, double{y}, double{z})))
                     ? 1
                     : 0;
  }
  EXPECT_GT(differing, 100);
}

TEST_F(SinglePrecision, IsCloseToDoubleOnHarmlessPoints) {
  set_matrix(0.5);
  const double rectangle = worst(traces::fb::LightShape_rectangle);
  EXPECT_GT(partial_, 2000);
  EXPECT_LE(rectangle, 1e-4);
  EXPECT_GE(rectangle, 1e-7) << "not in single precision";
  const double sphere = worst(traces::fb::LightShape_sphere);
  EXPECT_GT(partial_, 2000);
  EXPECT_LE(sphere, 1e-4);
  EXPECT_GE(sphere, 1e-7) << "not in single precision";
}

TEST_F(SinglePrecision, FailsWhereLargeTermsCancel) {
  set_matrix(1e6);
  EXPECT_GE(worst(traces::fb::LightShape_rectangle), 2.0 / 255.0);
  EXPECT_GE(worst(traces::fb::LightShape_sphere), 2.0 / 255.0);
}

TEST_F(SinglePrecision, IsSaturatedAsInAShader) {
  // Coordinates whose squares overflow: double has an answer, single precision none.
  set_matrix(0.5);
  trace_.header.lights[0].shape = traces::fb::LightShape_sphere;
  std::array<double, 16> m{};
  m[12] = 1e20;
  m[13] = m[14] = m[15] = 2e20;
  trace_.header.lights[0].light_from_window =
      traces::fb::Matrix4(flatbuffers::span<const double, 16>(m));
  traces::fb::Wedge wedge;
  wedge.mutate_kind(traces::fb::WedgeKind_coverage);
  wedge.mutable_edge_begin() = {-3, 0.5, 0.5};
  wedge.mutable_edge_end() = {3, 0.6, 0.5};
  EXPECT_GT(contribution(light_terms(trace_.view(), wedge), 0.5, 0.5, 0.5), 0.01);
  EXPECT_EQ(contribution(single_terms(trace_.view(), wedge), 0.5, 0.5, 0.5), 0.0);
}

TEST(LightTerms, FollowTheMatrixAndTheEdge) {
  // A pixel's point in light space by the matrix, then the formulas above.
  traces::Trace trace;
  trace.header.lights.resize(1);
  std::array<double, 16> m{0.01, 0.002, 0.003, 1e-4, -0.003, 0.02, 0.001, 2e-4,
                           0.5,  -0.4,  2.0,   0.1,  -1.0,   -0.5, 2.5,   1.0};
  traces::Light& light = trace.header.lights[0];
  light.light_from_window = traces::fb::Matrix4(flatbuffers::span<const double, 16>(m));
  traces::fb::Wedge wedge;
  wedge.mutable_edge_begin() = {-0.5, 0.2, 1.0};
  wedge.mutable_edge_end() = {0.7, 0.1, 1.3};
  wedge.mutate_kind(traces::fb::WedgeKind_coverage);
  const double x = 30.5, y = 20.5, z = 0.6;
  const auto row = [&](std::size_t r) {
    return m[r] * x + m[4 + r] * y + m[8 + r] * z + m[12 + r];
  };
  const glm::dvec3 p = glm::dvec3(row(0), row(1), row(2)) / row(3);
  const glm::dvec3 begin(-0.5, 0.2, 1.0), end(0.7, 0.1, 1.3);

  light.shape = traces::fb::LightShape_rectangle;
  const double rectangle = contribution(light_terms(trace.view(), wedge), x, y, z);
  EXPECT_GT(rectangle, 0.01);
  EXPECT_NEAR(rectangle, coverage(rectangle_at(p, begin, end), 0, 0, 0), 1e-12);

  light.shape = traces::fb::LightShape_sphere;
  const double sphere = contribution(light_terms(trace.view(), wedge), x, y, z);
  EXPECT_GT(sphere, 0.01);
  EXPECT_NEAR(sphere, coverage(sphere_at(p, 1.0, begin, end), 0, 0, 0), 1e-12);
}

LinearTerms linear_terms() {
  // Front z = 0.2, back z = 0.6, left x = 0, right x = 10.
  LinearTerms terms;
  terms.planes = {Plane{0, 0, 1, -0.2, false}, Plane{0, 0, 1, -0.6, true}, Plane{1, 0, 0, 0, false},
                  Plane{1, 0, 0, -10, true}};
  terms.factors = {1, 1, 1, 1, 1, 1};
  return terms;
}

TEST(Intensity, GoesFromLitAtTheFrontToDarkAtTheBack) {
  const LinearTerms terms = linear_terms();
  EXPECT_DOUBLE_EQ(intensity(terms, 5, 0, 0.2), 1.0);
  EXPECT_DOUBLE_EQ(intensity(terms, 5, 0, 0.6), 0.0);
  EXPECT_DOUBLE_EQ(intensity(terms, 5, 0, 0.3), 0.75);
}

TEST(Intensity, InterpolatesBetweenTheSides) {
  LinearTerms terms = linear_terms();
  terms.factors[0] = 3;  // on the left the front is three times as far
  const double left = intensity(terms, 0, 0, 0.4);
  const double right = intensity(terms, 10, 0, 0.4);
  EXPECT_DOUBLE_EQ(left, 0.25);  // back 1, front 3
  EXPECT_DOUBLE_EQ(right, 0.5);
  EXPECT_NEAR(intensity(terms, 2.5, 0, 0.4), 0.75 * left + 0.25 * right, 1e-15);
}

TEST(Intensity, InSinglePrecisionIsCloseToDouble) {
  const LinearTerms terms = linear_terms();
  LinearTermsOf<float> single;
  std::ranges::transform(terms.planes, single.planes.begin(), single_plane);
  single.factors = {1, 1, 1, 1, 1, 1};
  const auto s = static_cast<double>(intensity(single, 5.5F, 0.5F, 0.3F));
  EXPECT_NEAR(s, intensity(terms, 5.5, 0.5, static_cast<double>(0.3F)), 1e-6);
  EXPECT_NE(s, intensity(terms, 5.5, 0.5, static_cast<double>(0.3F))) << "not in single precision";
  single.factors = {};
  EXPECT_EQ(intensity(single, 5.5F, 0.5F, 0.3F), 0.5F);
}

TEST(Intensity, IsHalfWhereTheWedgeHasNoThickness) {
  LinearTerms terms = linear_terms();
  terms.planes[1].d = -0.2;
  EXPECT_EQ(intensity(terms, 5, 0, 0.2), 0.5);
}

}  // namespace
}  // namespace wedgesim::model
