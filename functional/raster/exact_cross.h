#pragma once

#include <glm/vec3.hpp>

namespace wedgesim::functional {

/// A difference of doubles, exactly: high is rounded, low what was lost (Møller, Knuth).
struct Difference {
  glm::dvec3 high, low{0.0};
  Difference(const glm::dvec3& a, const glm::dvec3& b) : high(a - b) {
    const glm::dvec3 of_b = a - high;
    low = (a - (high + of_b)) + (of_b - b);
  }
  explicit Difference(const glm::dvec3& direction) : high(direction) {}
};

/// p × q with almost all digits, also where the two are nearly parallel: each component is within
/// 2^-50 of its value plus 2^-100 of its two products. Swapping p and q changes the sign alone.
/// Source: products' difference after Kahan, whose fused multiply-add gives the rounding of a
/// product.
glm::dvec3 exact_cross(const Difference& p, const Difference& q);

}  // namespace wedgesim::functional
