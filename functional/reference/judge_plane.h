#pragma once

#include "functional/reference/real.h"

namespace wedgesim::functional {

/// A place as planes see it, in 200 bits and rounded.
struct JudgedPlace {
  RealVector exact;
  glm::dvec3 rounded{0.0};
  double terms = 0.0;  // the magnitude of what the place was added up from

  JudgedPlace() = default;
  JudgedPlace(const RealVector& place, double magnitude_of_terms)
      : exact(place), rounded(to_double(place)), terms(magnitude_of_terms) {}
};

/// A plane in 200 bits with the tie rule of a trace: inside iff (n·p + d ≥ 0) differs from minus.
/// Places are relative to the light's centre.
class JudgedPlane {
 public:
  JudgedPlane() = default;
  /// The plane of a shadow quad; into the shadow.
  /// \param begin, end  the edge relative to the light's centre
  /// \param minus       how a trace refers to it
  JudgedPlane(const RealVector& begin, const RealVector& end, bool minus);
  /// The plane across a vector, through a point.
  /// \param terms  the magnitude of what the vector was added up from
  JudgedPlane(const RealVector& inward, const RealVector& through, bool minus, double terms);

  /// n·p + d, as stored; 0 if it is only rounding.
  Real value(const JudgedPlace& place) const;
  bool inside(const JudgedPlace& place) const;
  const RealVector& normal() const { return normal_; }

 private:
  glm::dvec3 rounded_normal_{0.0};
  double rounded_offset_ = 0.0;
  bool minus_ = false;
  double normal_terms_ = 0.0;
  double offset_terms_ = 0.0;
  RealVector normal_;
  Real offset_ = 0;
};

}  // namespace wedgesim::functional
