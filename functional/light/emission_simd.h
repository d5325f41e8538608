// What a chord hides of a light with a texture (emission.h), in single precision, for the lanes of
// a vector at once. Compiled once for every instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_EMISSION_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_EMISSION_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_EMISSION_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_EMISSION_SIMD_H
#endif

#include <limits>

#include "functional/light/chord_simd.h"
#include "functional/light/emission.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

/// Emission::beyond.
struct EmissionLookup {
  static constexpr std::size_t kChannels = 3;
  const Emission& emission;

  HWY_INLINE void operator()(const Chords& chords, M counts, V* parts) const {
    const V zero = hn::Zero(kTag);
    const V cross = chords.cross();
    const Chords ordered = chords.exchanged(hn::Lt(cross, zero));
    const M here = hn::AndNot(same_direction(chords, cross), counts);
    const V whole = hn::IfThenElseZero(passes_start(ordered), set(1.0F));
    V sums[3] = {whole, whole, whole};
    add_round(ordered.qx, ordered.qy, here, 1.0F, sums);
    add_round(ordered.px, ordered.py, here, -1.0F, sums);
    add_along(ordered, here, -1.0F, sums);
    for (std::size_t c = 0; c < 3; ++c) {
      const V part = hn::Min(hn::Max(sums[c], zero), set(1.0F));
      parts[c] = hn::IfThenElseZero(here, part);
    }
  }

 private:
  // As far as single precision lets one see: what such a chord hides is below 1e-6.
  static HWY_INLINE M same_direction(const Chords& chords, V cross) {
    const V px_qy = hn::Mul(chords.px, chords.qy);
    const V py_qx = hn::Mul(chords.py, chords.qx);
    const V size = hn::Add(hn::Abs(px_qy), hn::Abs(py_qx));
    const V dot = hn::Add(hn::Mul(chords.px, chords.qx), hn::Mul(chords.py, chords.qy));
    return hn::And(hn::Ge(dot, hn::Zero(kTag)),
                   hn::Le(hn::Abs(cross), hn::Mul(set(2.5e-7F), size)));
  }

  static HWY_INLINE M passes_start(const Chords& chords) {
    const V zero = hn::Zero(kTag);
    const V at_p = hn::Add(chords.px, chords.py);
    const V at_q = hn::Add(chords.qx, chords.qy);
    const M before =
        hn::Or(hn::Lt(at_p, zero), hn::And(hn::Eq(at_p, zero), hn::Lt(chords.px, zero)));
    const M after =
        hn::Or(hn::Gt(at_q, zero), hn::And(hn::Eq(at_q, zero), hn::Gt(chords.qx, zero)));
    return hn::And(before, after);
  }

  HWY_INLINE V in_texels(V coordinate, int side) const {
    return hn::Mul(hn::Add(coordinate, set(1.0F)), set(0.5F * static_cast<float>(side)));
  }
  // The texel of a place, whatever a lane holds that does not count.
  static HWY_INLINE V texel(V place, int side) {
    const V low = hn::Floor(hn::IfThenElseZero(hn::Ge(place, hn::Zero(kTag)), place));
    return hn::Min(low, set(static_cast<float>(side - 1)));
  }

  // Emission::round.
  HWY_INLINE void add_round(V x, V y, M counts, float sign, V* sums) const {
    const V zero = hn::Zero(kTag);
    const V reach = hn::Max(hn::Abs(x), hn::Abs(y));
    const M centre = hn::Eq(reach, zero);
    const V exit_x = hn::IfThenElse(centre, set(1.0F), hn::Div(x, reach));
    const V exit_y = hn::IfThenElse(centre, zero, hn::Div(y, reach));
    const M right = hn::And(hn::Gt(exit_x, zero), hn::Ge(exit_x, hn::Abs(exit_y)));
    const V at = in_texels(exit_y, emission.height());
    const V row = texel(at, emission.height());
    const V into = hn::Sub(at, row);
    const I first = hn::Mul(hn::ConvertTo(kInts, row), hn::Set(kInts, 3));
    const float* below = emission.below();
    const float* all = below + 3 * emission.height();
    for (std::size_t c = 0; c < 3; ++c) {
      const I place = hn::Add(first, hn::Set(kInts, static_cast<int>(c)));
      const V low = hn::GatherIndex(kTag, below, place);
      const V high = hn::GatherIndex(kTag, below, hn::Add(place, hn::Set(kInts, 3)));
      const V on_right = hn::Add(low, hn::Mul(into, hn::Sub(high, low)));
      sums[c] = hn::Add(sums[c], hn::Mul(set(sign), hn::IfThenElse(right, on_right, set(all[c]))));
    }
    add_along({exit_x, exit_y, x, y}, counts, sign, sums);
  }

  // From a coordinate along a segment to the next line between texels.
  struct Crossings {
    HWY_INLINE Crossings(V begin, V way) : from(begin) {
      const V one = set(1.0F);
      const M up = hn::Gt(way, hn::Zero(kTag));
      next = hn::IfThenElse(up, hn::Add(hn::Floor(begin), one), hn::Sub(hn::Ceil(begin), one));
      step = hn::IfThenElse(up, one, set(-1.0F));
      inverse = hn::Div(one, way);
      none = hn::Eq(way, hn::Zero(kTag));
    }
    HWY_INLINE V at() const {
      return hn::IfThenElse(none, set(std::numeric_limits<float>::infinity()),
                            hn::Mul(hn::Sub(next, from), inverse));
    }
    HWY_INLINE void pass(M crossed) { next = hn::Add(next, hn::IfThenElseZero(crossed, step)); }
    V from, next, step, inverse;
    M none;
  };

  // Emission::add_along.
  HWY_INLINE void add_along(const Chords& chords, M counts, float sign, V* sums) const {
    const int width = emission.width();
    const int height = emission.height();
    const V one = set(1.0F);
    const V begin_x = in_texels(chords.px, width);
    const V begin_y = in_texels(chords.py, height);
    const V way_x = hn::Sub(in_texels(chords.qx, width), begin_x);
    const V way_y = hn::Sub(in_texels(chords.qy, height), begin_y);
    const M goes = hn::AndNot(hn::Eq(way_y, hn::Zero(kTag)), counts);
    V t = hn::IfThenZeroElse(goes, one);
    Crossings in_x(begin_x, way_x);
    Crossings in_y(begin_y, way_y);
    for (int most = width + height + 4; most > 0; --most) {  // each step passes a line
      const M live = hn::Lt(t, one);
      if (hn::AllFalse(kTag, live)) return;
      const V at_x = in_x.at();
      const V at_y = in_y.at();
      const V next = hn::Min(one, hn::Min(at_x, at_y));
      in_x.pass(hn::Le(at_x, next));
      in_y.pass(hn::Le(at_y, next));
      const V middle = hn::Mul(set(0.5F), hn::Add(t, next));
      const V x = hn::Add(begin_x, hn::Mul(middle, way_x));
      const V column = texel(x, width);
      const V row = texel(hn::Add(begin_y, hn::Mul(middle, way_y)), height);
      const V number = hn::Add(hn::Mul(row, set(static_cast<float>(width))), column);
      const I first = hn::Mul(hn::ConvertTo(kInts, number), hn::Set(kInts, 6));
      const V into = hn::Sub(x, column);
      const V up = hn::Mul(hn::Mul(set(sign), hn::Sub(next, t)), way_y);
      for (std::size_t c = 0; c < 3; ++c) {
        const I place = hn::Add(first, hn::Set(kInts, static_cast<int>(c)));
        const V before = hn::GatherIndex(kTag, emission.texels(), place);
        const V share = hn::GatherIndex(kTag, emission.texels(), hn::Add(place, hn::Set(kInts, 3)));
        const V part = hn::Mul(up, hn::Add(before, hn::Mul(into, share)));
        sums[c] = hn::Add(sums[c], hn::IfThenElseZero(live, part));
      }
      t = hn::IfThenElse(live, next, t);
    }
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_EMISSION_SIMD_H
