#include "model/count/operands.h"

#include <cmath>

#include "model/datapath/setup.h"
#include "traces/depth.h"

namespace wedgesim::model {
namespace {

bool fits(std::int64_t value, int bits) { return datapath::LiWord{bits, 0}.holds(value); }

// The nearest float. Rounding is monotone: what is in an interval is in the rounded one.
double to_single(double value) { return static_cast<double>(static_cast<float>(value)); }

}  // namespace

double Datapath::one() const {
  if (kind == DatapathKind::fixed) return static_cast<double>(formats.li.one());
  return word_one(kind);
}

bool Datapath::li_holds(std::int64_t word) const {
  if (kind == DatapathKind::fixed) return formats.li.holds(word);
  // The default format's range, whatever is behind the point; paper255: 16-bit integers.
  return fits(word, kind == DatapathKind::paper255 ? 16 : datapath::LiWord{}.integer_bits + 40);
}

bool Datapath::stencil_holds(std::int64_t stencil) const {
  return fits(stencil, kind == DatapathKind::fixed ? formats.stencil_bits : 8);
}

Operands::Operands(const traces::TraceView& trace, const Datapath& datapath)
    : trace_(trace), datapath_(datapath), steps_(trace.header.depth_format, trace.depth) {}

Plane Operands::plane(std::uint32_t reference) const {
  if (single()) return single_plane(resolve(trace_, reference));
  if (!fixed()) return resolve(trace_, reference);
  const datapath::FixedPlane plane =
      datapath::plane_setup(trace_, reference, steps_, datapath_.formats);
  const auto coefficient = [&](std::int64_t integer, int shift) {
    return std::ldexp(static_cast<double>(integer), plane.form.exponent + shift);
  };
  return {coefficient(plane.form.a, 1),
          coefficient(plane.form.b, 1),
          coefficient(plane.form.c, 0),
          coefficient(plane.form.d, 0),
          plane.minus,
          Arithmetic::fixed,
          plane.form};
}

// Adding 0 turns -0 into +0: no difference of depths is then -0, whose sign bit the kernels read.
ZInterval Operands::interval(double z_min, double z_max) const {
  if (single()) return {to_single(z_min + 0.0), to_single(z_max + 0.0)};
  if (!fixed()) return {z_min + 0.0, z_max + 0.0};
  return {static_cast<double>(steps_.first(z_min)), static_cast<double>(steps_.last(z_max))};
}

ZInterval Operands::around(double z_min, double z_max) const {
  if (single()) return {to_single(z_min), to_single(z_max)};
  if (!fixed()) return {z_min, z_max};
  return {static_cast<double>(steps_.last(z_min)), static_cast<double>(steps_.first(z_max))};
}

double Operands::depth(std::uint32_t word) const {
  if (single()) return to_single(traces::decode_depth(trace_.header.depth_format, word));
  if (!fixed()) return traces::decode_depth(trace_.header.depth_format, word);
  return static_cast<double>(steps_.of_word(word));
}

double Operands::far() const { return fixed() ? static_cast<double>(steps_.high()) : 1.0; }

LightTerms Operands::terms(const traces::fb::Wedge& wedge) const {
  if (single()) return single_terms(trace_, wedge);
  if (!fixed()) return light_terms(trace_, wedge);
  return FixedTerms{datapath::light_setup(trace_, wedge, steps_, datapath_.formats),
                    datapath_.formats.round()};
}

}  // namespace wedgesim::model
