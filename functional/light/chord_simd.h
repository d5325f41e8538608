// What edges hide of a rectangular light by lookups with the chords that they project to, for the
// lanes of a vector at once. Compiled once for every instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_CHORD_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_CHORD_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_CHORD_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_CHORD_SIMD_H
#endif

#include "functional/light/coverage_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

constexpr hn::RebindToSigned<D> kInts;
using I = hn::Vec<decltype(kInts)>;

// A chord of the light, half axes.
struct Chords {
  V px, py, qx, qy;
  HWY_INLINE V cross() const { return hn::Sub(hn::Mul(px, qy), hn::Mul(py, qx)); }
  // The ends the other way round where asked for.
  HWY_INLINE Chords exchanged(M where) const {
    return {hn::IfThenElse(where, qx, px), hn::IfThenElse(where, qy, py),
            hn::IfThenElse(where, px, qx), hn::IfThenElse(where, py, qy)};
  }
};

HWY_INLINE V signed_share(M inner, V covered) {
  return hn::IfThenElse(inner, covered, hn::Neg(covered));
}

/// Clipping as RectangleShare, then a Lookup:
///   kChannels                       values it gives
///   operator()(chords, counts, parts)  parts[channel]; of lanes that do not count, anything
template <typename Lookup>
struct ChordShare {
  static constexpr std::size_t kForms = RectangleShare::kForms;
  static constexpr std::size_t kChannels = Lookup::kChannels;
  Lookup lookup;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge&, M inner, V* shares, M&) const {
    const SeenEdge seen = see_edge(forms);
    const V zero = hn::Zero(kTag);
    const M counts = hn::And(seen.alive, hn::And(hn::Gt(seen.pw, zero), hn::Gt(seen.qw, zero)));
    if (hn::AllFalse(kTag, counts)) return counts;
    const Chords chords{hn::Div(seen.pu, seen.pw), hn::Div(seen.pv, seen.pw),
                        hn::Div(seen.qu, seen.qw), hn::Div(seen.qv, seen.qw)};
    lookup(chords, counts, shares);
    for (std::size_t c = 0; c < kChannels; ++c) shares[c] = signed_share(inner, shares[c]);
    return counts;
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_CHORD_SIMD_H
