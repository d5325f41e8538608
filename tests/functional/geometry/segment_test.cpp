#include "functional/geometry/segment.h"

#include <gtest/gtest.h>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

// A segment through a known point of a triangle is cut there; one that ends before it, or passes
// beside it, is not.
TEST(Segment, CutsWhereItShould) {
  Random random(62);
  for (int i = 0; i < 10000; ++i) {
    const glm::dvec3 a = random.in_box(glm::dvec3(-5.0), glm::dvec3(5.0));
    const glm::dvec3 b = a + random.uniform(1.0, 5.0) * random.direction();
    const glm::dvec3 c = a + random.uniform(1.0, 5.0) * random.direction();
    const glm::dvec3 n = glm::cross(b - a, c - a);
    if (glm::length(n) < 0.1) continue;
    double u = random.uniform(-1.0, 2.0);
    double v = random.uniform(-1.0, 2.0);
    const double margin = std::min({u, v, 1.0 - u - v});
    if (std::abs(margin) < 1e-6) continue;
    const glm::dvec3 p = a + u * (b - a) + v * (c - a);
    const glm::dvec3 from = p + random.uniform(0.5, 5.0) * random.direction();
    if (std::abs(glm::dot(glm::normalize(n), from - p)) < 1e-2) continue;
    const double share = random.uniform(0.1, 1.5);
    const glm::dvec3 to = from + (p - from) / share;
    const auto cut = segment_triangle(from, to, a, b, c);
    ASSERT_EQ(cut.has_value(), margin > 0.0 && share < 1.0) << "case " << i;
    ASSERT_NEAR(cut.value_or(share), share, 1e-9);
    const auto other_side = segment_triangle(from, to, a, c, b);
    ASSERT_EQ(other_side.has_value(), cut.has_value());
  }
}

TEST(Segment, AlongThePlaneIsNoCut) {
  const glm::dvec3 a(0, 0, 0);
  const glm::dvec3 b(1, 0, 0);
  const glm::dvec3 c(0, 1, 0);
  EXPECT_FALSE(segment_triangle({-1, 0.2, 0}, {2, 0.2, 0}, a, b, c));
  EXPECT_FALSE(segment_triangle({-1, 0.2, 1}, {2, 0.2, 1}, a, b, c));
}

}  // namespace
}  // namespace wedgesim::functional
