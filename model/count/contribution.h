#pragma once

#include <array>
#include <bit>
#include <cstdint>
#include <glm/vec3.hpp>
#include <variant>

#include "model/count/config.h"
#include "model/count/plane.h"
#include "model/datapath/setup.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// A value linear in (x, y, z, 1), window space, evaluated as planes are.
struct Row {
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
  double at(double x, double y, double z) const { return ((a * x + b * y) + c * z) + d; }
};

/// `linear`: planes front, back, left, right and the factors that turn their inward values into
/// distances. Paper I, Eqs. 1-3.
struct LinearTerms {
  std::array<Plane, 4> planes;
  std::array<double, 6> factors{};
};

/// `coverage`, rectangular light: the edge's ends projected from the point onto the light's plane,
/// where the light is the square [-1, 1]^2; homogeneous, (u, v, w) of each.
struct RectangleTerms {
  struct End {
    Row u, v, w;
  };
  std::array<End, 2> ends;
};

/// `coverage`, spherical light: the point's homogeneous position about the light's centre, in
/// radii, and the edge there.
struct SphereTerms {
  Row x, y, z, w;
  glm::dvec3 begin{0.0};
  glm::dvec3 edge{0.0};    // end - begin
  glm::dvec3 normal{0.0};  // begin x end
};

/// Any of them, in the arithmetic of the fixed datapath.
struct FixedTerms {
  datapath::LightSetup setup;
  datapath::Rounder round{datapath::Rounder::kMaxBits};
};

using LightTerms = std::variant<LinearTerms, RectangleTerms, SphereTerms, FixedTerms>;

/// Per-wedge constants of the light intensity or coverage, for the exact datapath.
LightTerms light_terms(const traces::TraceView& trace, const traces::fb::Wedge& wedge);

/// The light intensity s of a `linear` wedge at a point inside, in [0, 1]: 1 at the front plane, 0
/// at the back plane; 0.5 where the wedge has no thickness or no length.
/// \param x, y, z  window space: pixels and depth
double intensity(const LinearTerms& terms, double x, double y, double z);

/// The fraction of the light that the half-plane-like shadow of one edge hides, without a sign:
/// the area between the clipped projection of the edge and the light's outline, as seen between
/// the rays from the light's centre through its ends.
/// \param x, y, z  window space: pixels and depth
/// \return         [0, 0.5]; 0 if the edge's projection misses the light
/// Accuracy: within 1e-9 of sampling by polygon clipping (contribution_test.cpp)
double coverage(const RectangleTerms& terms, double x, double y, double z);
/// \copydoc coverage. The outline is the circle in which the tangent cone from the point touches.
/// 0 if the point is inside the light.
double coverage(const SphereTerms& terms, double x, double y, double z);

/// \param z  depth, in steps for FixedTerms
double contribution(const LightTerms& terms, double x, double y, double z);

/// What 1.0 is in the words of a format that has one width.
constexpr double word_one(DatapathKind format) {
  return format == DatapathKind::exact ? 1099511627776.0 : 255.0;
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
