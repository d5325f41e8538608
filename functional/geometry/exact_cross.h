#pragma once

#include <glm/vec3.hpp>

namespace wedgesim::functional {

/// (a − origin) × (b − origin) with almost all digits, also where the two ways are nearly parallel:
/// each component is within 2^-50 of its value plus 2^-100 of its two products. Swapping a and b
/// changes the sign alone.
/// Source: differences as unevaluated sums (Møller, Knuth); products' difference after Kahan, whose
/// fused multiply-add gives the rounding of a product.
glm::dvec3 exact_cross(const glm::dvec3& origin, const glm::dvec3& a, const glm::dvec3& b);

}  // namespace wedgesim::functional
