#include "functional/raster/exact_cross.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "functional/reference/real.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

// Are almost all digits right, whatever is left of the products?
TEST(ExactCross, KeepsItsDigitsWhereWaysAreNearlyParallel) {
  Random random(31);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 origin = random.in_box(glm::dvec3(-3.0), glm::dvec3(3.0));
    const glm::dvec3 a = random.in_box(glm::dvec3(-9.0), glm::dvec3(9.0));
    const double aside = std::exp2(-random.uniform(0.0, 52.0));
    const glm::dvec3 b =
        origin + random.uniform(0.1, 3.0) * (a - origin) + aside * random.direction();
    const RealVector from(origin);
    const RealVector p = RealVector(a) - from;
    const RealVector q = RealVector(b) - from;
    const RealVector exact = cross(p, q);
    const glm::dvec3 own = exact_cross({a, origin}, {b, origin});
    const double products = magnitude(p) * magnitude(q);
    const glm::dvec3 right = to_double(exact);
    for (int k = 0; k < 3; ++k) {
      ASSERT_NEAR(own[k], right[k], 0x1p-50 * std::abs(right[k]) + 0x1p-100 * products)
          << "case " << i;
    }
    ASSERT_EQ(exact_cross({b, origin}, {a, origin}), -own) << "case " << i;
  }
}

}  // namespace
}  // namespace wedgesim::functional
