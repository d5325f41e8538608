#include "functional/reference/judge_plane.h"

#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

// A sign in double counts if the value is more than this part of its terms, which are far from
// underflow.
constexpr double kRounding = 1e-12;
constexpr double kTooSmall = 1e-280;

}  // namespace

JudgedPlane::JudgedPlane(const RealVector& begin, const RealVector& end, bool minus)
    : minus_(minus),
      normal_terms_(magnitude(begin) * magnitude(end)),
      normal_(minus ? cross(begin, end) : cross(end, begin)) {
  rounded_normal_ = to_double(normal_);
}

JudgedPlane::JudgedPlane(const RealVector& inward, const RealVector& through, bool minus,
                         double terms)
    : minus_(minus),
      normal_terms_(terms),
      offset_terms_(terms * magnitude(through)),
      normal_(minus ? Real(-1) * inward : inward) {
  offset_ = -dot(normal_, through);
  rounded_normal_ = to_double(normal_);
  rounded_offset_ = offset_.convert_to<double>();
}

Real JudgedPlane::value(const JudgedPlace& place) const {
  const Real value = dot(normal_, place.exact) + offset_;
  const double terms = normal_terms_ * place.terms + offset_terms_;
  return abs(value) <= kRealTie * terms ? Real(0) : value;
}

bool JudgedPlane::inside(const JudgedPlace& place) const {
  const double rough = glm::dot(rounded_normal_, place.rounded) + rounded_offset_;
  const double terms =
      glm::dot(glm::abs(rounded_normal_), glm::abs(place.rounded)) + std::abs(rounded_offset_);
  if (terms > kTooSmall && std::abs(rough) > kRounding * terms) return (rough > 0.0) != minus_;
  return (value(place) >= 0) != minus_;
}

}  // namespace wedgesim::functional
