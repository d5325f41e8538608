#include "reports/stress/exact_plane.h"

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>

namespace wedgesim::reports::stress {

int exact_sign(const traces::fb::Plane& plane, double x, double y, double z) {
  const double terms[] = {plane.a() * x, plane.b() * y, plane.c() * z, plane.d()};
  double sum = 0.0;
  double size = 0.0;
  for (const double term : terms) {
    sum += term;
    size += std::fabs(term);
  }
  // Seven roundings of at most half a unit each; far from 0 they cannot change the sign.
  if (std::fabs(sum) > 1e-15 * size) return sum > 0.0 ? 1 : -1;
  // Products of two doubles have 106 bits; their sum has no more than what lies between the
  // largest and the last bit of the least, which 1,000 digits hold for all but absurd ranges.
  using Real = boost::multiprecision::number<boost::multiprecision::mpfr_float_backend<1000>,
                                             boost::multiprecision::et_off>;
  const Real value =
      (Real(plane.a()) * x + Real(plane.b()) * y) + (Real(plane.c()) * z + plane.d());
  return value.sign();
}

}  // namespace wedgesim::reports::stress
