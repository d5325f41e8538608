#pragma once

#include <cstdint>
#include <span>
#include <string_view>

#include "model/datapath/rounder.h"
#include "traces/trace_generated.h"

namespace wedgesim::model::datapath {

/// A value linear in window space: pixels x and y, depth z.
struct LinearForm {
  double a = 0.0, b = 0.0, c = 0.0, d = 0.0;
};

/// p f + q g + r h. Each coefficient is within 2^-52 of its value plus 2^-104 of its terms, which
/// may be far larger: those of c and d are, where depth is coarse.
LinearForm combine(const LinearForm& p, double f, const LinearForm& q, double g,
                   const LinearForm& r = {}, double h = 0.0);

/// How the datapath sees a stored depth: a whole number of steps, more of them farther away.
/// unorm words are taken as they are, float32 is rounded to 2^-26. float32_reversed keeps its
/// precision near the far plane: steps count back from there, and are the 2^26th part of the
/// greatest stored value of the frame, rounded up to a power of two.
class ZSteps {
 public:
  /// \param words  the frame's depth; only float32_reversed looks at it (none: up to 1)
  explicit ZSteps(traces::fb::DepthFormat format, std::span<const std::uint32_t> words = {});

  /// Steps in a window depth of 1.
  double one() const { return one_; }
  /// The window depth of step 0: 0, or 1 if steps count back from the far plane.
  double origin() const { return origin_; }
  /// The steps that a stored depth may be: high() is window depth 1.
  std::int64_t low() const { return low_; }
  std::int64_t high() const { return high_; }
  /// \return  [low(), high()]
  std::int64_t of_word(std::uint32_t word) const;
  /// The same before it is rounded to a whole step.
  double unrounded(std::uint32_t word) const;
  /// The first step not below a window depth, and the last not above it: a stored depth is in
  /// [z_min, z_max] iff its steps are in [first(z_min), last(z_max)] (for unorm depths). At most
  /// one beyond low() and high().
  std::int64_t first(double z) const;
  std::int64_t last(double z) const;

 private:
  traces::fb::DepthFormat format_;
  double one_ = 0.0;
  double origin_ = 0.0;
  std::int64_t low_ = 0;
  std::int64_t high_ = 0;
};

/// A pixel's centre or a box's corner, as the datapath takes it.
struct Place {
  std::int64_t x = 0, y = 0;  // half pixels, [0, 2^15]
  std::int64_t z = 0;         // steps
};

/// \param x, y  pixels, multiples of 1/2
/// \param z     steps
inline Place place(double x, double y, double z) {
  return {static_cast<std::int64_t>(2.0 * x), static_cast<std::int64_t>(2.0 * y),
          static_cast<std::int64_t>(z)};
}

/// A linear form of the fixed datapath: value = (((a x + b y) + c z) + d) * 2^exponent in integers,
/// x and y in half pixels, z in steps.
///
/// With B = 2^14 (|a| + |b|) + |c| Z + |d| per pixel and window depth, Z the depth that the frame's
/// steps span and d the value at step 0, the exponent is the least for
/// which B <= 2^(bits - 1 + exponent): no value, no sum on the way to it and no difference of two
/// values on one exponent overflows `bits + 1` bits, so the order of the sum does not matter.
/// Hardware keeps the value at the corner of an 8x8 block, adds multiples of a and b, which takes
/// adders alone, and one product c * z.
/// Error: at most 2^(25 - bits) B with unorm24, nearly all of it by c.
/// Invariant: a corner of a box is evaluated as pixels are, so box tests are exact for every tile.
struct FixedForm {
  std::int64_t a = 0, b = 0, c = 0, d = 0;
  int exponent = 0;

  std::int64_t at(const Place& place) const { return a * place.x + b * place.y + c * place.z + d; }
  /// The value as a real.
  double at(const Place& place, Rounder round) const { return round(at(place), exponent); }
};

/// The fewest `form_bits` of a frame: a sign, and room for a step of depth and for a pixel in the
/// largest form that changes by its bound across the frame. With fewer depth itself is lost; the
/// pixel bars need more (docs/datapath.md).
int least_form_bits(traces::fb::DepthFormat depth, unsigned width, unsigned height);

/// \param place  where form_bits was chosen
/// \throws InputError naming form_bits and what the frame needs
void require_form_bits(int form_bits, traces::fb::DepthFormat depth, unsigned width,
                       unsigned height, std::string_view place);

/// The least exponent that all forms fit.
int common_exponent(std::span<const LinearForm> forms, const ZSteps& steps, int form_bits);

/// A form with its coefficients rounded to multiples of 2^exponent, ties to even.
FixedForm quantize(const LinearForm& form, const ZSteps& steps, int exponent);

/// A form on an exponent of its own.
FixedForm quantize_alone(const LinearForm& form, const ZSteps& steps, int form_bits);

}  // namespace wedgesim::model::datapath
