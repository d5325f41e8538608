#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <type_traits>
#include <variant>

#include "model/count/config.h"
#include "model/count/plane.h"
#include "model/datapath/setup.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// `linear`: planes front, back, left, right and the factors that turn their inward values into
/// distances. Paper I, Eqs. 1-3.
template <typename Real>
struct LinearTermsOf {
  std::array<Plane, 4> planes;  // evaluated in Real
  std::array<Real, 6> factors{};
};

/// `coverage`, rectangular light: the edge's ends projected from the point onto the light's plane,
/// where the light is the square [-1, 1]^2; homogeneous, (u, v, w) of each.
template <typename Real>
struct RectangleTermsOf {
  struct End {
    RowOf<Real> u, v, w;
  };
  std::array<End, 2> ends;
};

/// `coverage`, spherical light: the point in the edge's frame about the light's centre, homogeneous
/// and in radii, and the edge there (disc_frame.h).
template <typename Real>
struct SphereTermsOf {
  RowOf<Real> along, out, normal, w;
  Real distance = 0, distance_squared = 0;  // of the edge's line from the centre
  std::array<Real, 2> ends{};               // their coordinates along the edge, increasing
};

using LinearTerms = LinearTermsOf<double>;
using RectangleTerms = RectangleTermsOf<double>;
using SphereTerms = SphereTermsOf<double>;

/// Any of them in single precision.
using SingleTerms =
    std::variant<LinearTermsOf<float>, RectangleTermsOf<float>, SphereTermsOf<float>>;

/// Any of them, in the arithmetic of the fixed datapath.
struct FixedTerms {
  datapath::LightSetup setup;
  datapath::Rounder round{datapath::Rounder::kMaxBits};
};

using LightTerms = std::variant<LinearTerms, RectangleTerms, SphereTerms, FixedTerms, SingleTerms>;

/// \param light       homogeneous light space from window space
/// \param begin, end  of the edge, light space: radii
SphereTerms sphere_terms(const std::array<Row, 4>& light, const glm::dvec3& begin,
                         const glm::dvec3& end);

/// Per-wedge constants of the light intensity or coverage, for the exact datapath.
LightTerms light_terms(const traces::TraceView& trace, const traces::fb::Wedge& wedge);

/// A plane for single precision: each coefficient rounded once.
Plane single_plane(const Plane& plane);

/// light_terms(), each constant rounded once to single precision.
SingleTerms single_terms(const traces::TraceView& trace, const traces::fb::Wedge& wedge);

/// The light intensity s of a `linear` wedge at a point inside, in [0, 1]: 1 at the front plane, 0
/// at the back plane; 0.5 where the wedge has no thickness or no length.
/// \tparam Real    double or float: that of every operator
/// \param x, y, z  window space: pixels and depth
template <typename Real>
Real intensity(const LinearTermsOf<Real>& terms, std::type_identity_t<Real> x,
               std::type_identity_t<Real> y, std::type_identity_t<Real> z);

/// The fraction of the light that the half-plane-like shadow of one edge hides, without a sign:
/// the area between the clipped projection of the edge and the light's outline, as seen between
/// the rays from the light's centre through its ends.
/// \param x, y, z  window space: pixels and depth
/// \return         [0, 0.5]; 0 if the edge's projection misses the light
/// Accuracy: in double of a rectangle within 1e-9 of sampling by polygon clipping
///           (contribution_test.cpp), of a sphere within 1e-11 of the judge's 200 bits
///           (judge_coverage_test.cpp)
template <typename Real>
Real coverage(const RectangleTermsOf<Real>& terms, std::type_identity_t<Real> x,
              std::type_identity_t<Real> y, std::type_identity_t<Real> z);
/// \copydoc coverage. The outline is the circle in which the tangent cone from the point touches.
/// 0 if the point is inside the light. As datapath::coverage of a DiscSetup, whose comment explains
/// it: nothing that is small is the difference of what is large.
template <typename Real>
Real coverage(const SphereTermsOf<Real>& terms, std::type_identity_t<Real> x,
              std::type_identity_t<Real> y, std::type_identity_t<Real> z);

/// What single precision gives before it is saturated: anything, infinities and NaN included.
float unsaturated(const SingleTerms& terms, float x, float y, float z);

/// Any of them. In single precision limited to [0, 1], NaN to 0, as shaders saturate: nothing
/// else keeps what has lost all its bits out of the sums.
/// \param z  depth, in steps for FixedTerms
double contribution(const LightTerms& terms, double x, double y, double z);

/// What 1.0 is in the words of a format that has one width.
constexpr double word_one(DatapathKind format) {
  return format == DatapathKind::paper255 ? 255.0 : 0x1p40;
}

/// Adding 1.5 * 2^52 leaves the nearest integer, ties to even, in the low bits.
inline constexpr double kRoundMagic = 6755399441055744.0;

/// A contribution as a word, rounded once to nearest, ties to even.
/// \param value  |value * one| < 2^51
inline std::int64_t to_word(double value, double one) {
  return std::bit_cast<std::int64_t>(value * one + kRoundMagic) -
         std::bit_cast<std::int64_t>(kRoundMagic);
}

}  // namespace wedgesim::model
