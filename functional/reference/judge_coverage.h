#pragma once

#include <array>

#include "functional/reference/real.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Light space of 200 bits, from the light as it was given: of a rectangle, u and v in half axes
/// and the distance from its plane in any unit; of a sphere, world axes about the centre, in radii.
class JudgedLight {
 public:
  explicit JudgedLight(const Light& light);
  /// \param from_centre  world axes and units, from the light's centre
  RealVector operator()(const RealVector& from_centre) const;

 private:
  std::array<RealVector, 3> rows_;
};

/// The fraction of a light that an edge hides from a point, as rectangle_coverage and
/// sphere_coverage define it (coverage.h), by other formulas: the square clipped by three
/// half-planes; the circular segment by the foot of the edge's line, without a basis.
/// \param point, begin, end  light space; an edge of a rectangle has third coordinates above 0
/// \return [0, 1/2], within 2^-170 but for near-degenerate input. Degenerate input: 0 if the edge
///         has no length or the point is on its line (so also on the edge itself), if the point is
///         behind the light's plane, in the sphere or on it; 1/2 if the light's centre is on the
///         projected edge, whose ends lie outside the light; where an end projects onto the
///         centre, its ray goes towards (1, 0) on a rectangle, and on a disc the answer is 0.
Real judged_rectangle_coverage(const RealVector& point, const RealVector& begin,
                               const RealVector& end);
Real judged_sphere_coverage(const RealVector& point, const RealVector& begin,
                            const RealVector& end);
/// By the light's shape; 0 for a point.
Real judged_coverage(LightShape shape, const RealVector& point, const RealVector& begin,
                     const RealVector& end);

/// What of a point decides in double whether an edge may cover any of a light.
class CoverageFilter {
 public:
  CoverageFilter(LightShape shape, const RealVector& point);
  /// False only if the edge covers nothing: all of it is beyond one side of a square around the
  /// light, or not in front of the point, by more than rounding.
  /// \param begin, end  light space, rounded to double
  bool may_cover(const glm::dvec3& begin, const glm::dvec3& end) const;

 private:
  struct Seen {
    double u, v, w, error;
  };
  Seen see(const glm::dvec3& e) const;

  bool rectangle_;
  bool reached_ = true;  // by the light at all
  glm::dvec3 point_;
  glm::dvec3 axis_{0.0}, across_u_{0.0}, across_v_{0.0};  // sphere; the axis times tan of the cone
};

}  // namespace wedgesim::functional
