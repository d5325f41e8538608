#pragma once

#include <boost/multiprecision/mpfr.hpp>
#include <cmath>
#include <glm/vec3.hpp>

namespace wedgesim::functional {

/// 200 bits, on the stack.
using Real = boost::multiprecision::number<
    boost::multiprecision::mpfr_float_backend<60, boost::multiprecision::allocate_stack>,
    boost::multiprecision::et_off>;

/// A value that is less than this part of what it was added up from is 0: rounding leaves a few
/// units in 2^-200.
inline constexpr double kRealTie = 0x1p-175;

struct RealVector {
  Real x, y, z;
  RealVector() : x(0), y(0), z(0) {}
  RealVector(Real vx, Real vy, Real vz) : x(vx), y(vy), z(vz) {}
  explicit RealVector(const glm::dvec3& v) : x(v.x), y(v.y), z(v.z) {}
};

inline RealVector operator+(const RealVector& a, const RealVector& b) {
  return {a.x + b.x, a.y + b.y, a.z + b.z};
}
inline RealVector operator-(const RealVector& a, const RealVector& b) {
  return {a.x - b.x, a.y - b.y, a.z - b.z};
}
inline RealVector operator*(const Real& s, const RealVector& v) {
  return {s * v.x, s * v.y, s * v.z};
}
inline Real dot(const RealVector& a, const RealVector& b) {
  return a.x * b.x + a.y * b.y + a.z * b.z;
}
inline RealVector cross(const RealVector& a, const RealVector& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}
inline RealVector unit(const RealVector& v) { return Real(1 / sqrt(dot(v, v))) * v; }

inline glm::dvec3 to_double(const RealVector& v) {
  return {v.x.convert_to<double>(), v.y.convert_to<double>(), v.z.convert_to<double>()};
}
/// The largest coordinate.
inline double magnitude(const RealVector& v) {
  const glm::dvec3 d = to_double(v);
  return std::fmax(std::abs(d.x), std::fmax(std::abs(d.y), std::abs(d.z)));
}

}  // namespace wedgesim::functional
