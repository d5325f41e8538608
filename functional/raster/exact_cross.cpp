#include "functional/raster/exact_cross.h"

#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

// The larger first: both orders give the same digits.
double difference_of_products(double a, double b, double c, double d) {
  const double product = c * d;
  if (a * b < product) return -difference_of_products(c, d, a, b);
  const double lost = std::fma(-c, d, product);
  return std::fma(a, b, -product) + lost;
}

}  // namespace

glm::dvec3 exact_cross(const Difference& p, const Difference& q) {
  const glm::dvec3 high(difference_of_products(p.high.y, q.high.z, p.high.z, q.high.y),
                        difference_of_products(p.high.z, q.high.x, p.high.x, q.high.z),
                        difference_of_products(p.high.x, q.high.y, p.high.y, q.high.x));
  return high + (glm::cross(p.high, q.low) + glm::cross(p.low, q.high));
}

}  // namespace wedgesim::functional
