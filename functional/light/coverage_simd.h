// How much of a light a silhouette edge covers, in single precision, for the lanes of a vector at
// once: coverage.h, from window forms that are linear in a tile. Compiled once for every
// instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_COVERAGE_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_COVERAGE_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_COVERAGE_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_COVERAGE_SIMD_H
#endif

#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

/// No wedges: umbra polygons alone.
struct NoShare {
  static constexpr std::size_t kForms = 0;
  static constexpr std::size_t kChannels = 1;
};

// The shares of a segment that are cut off from its begin and from its end, and those left from
// there on to the other end, each with its own digits: coverage.cpp.
struct Cut {
  V begin, left_of_begin, end, left_of_end;
};

HWY_INLINE void clip(V f0, V f1, Cut& cut) {
  const V zero = hn::Zero(kTag);
  const M out0 = hn::Lt(f0, zero);
  const M out1 = hn::Lt(f1, zero);
  // Of the end that is outside; both are in lanes that are not alive.
  const V per_length = hn::Div(set(1.0F), hn::Sub(f0, f1));
  const V share = hn::Mul(hn::IfThenElse(out0, f0, hn::Neg(f1)), per_length);
  const V left = hn::Mul(hn::IfThenElse(out0, hn::Neg(f1), f0), per_length);
  const M begins = hn::And(out0, hn::Gt(share, cut.begin));
  const M ends = hn::And(out1, hn::Gt(share, cut.end));
  cut.begin = hn::IfThenElse(begins, share, cut.begin);
  cut.left_of_begin = hn::IfThenElse(begins, left, cut.left_of_begin);
  cut.end = hn::IfThenElse(ends, share, cut.end);
  cut.left_of_end = hn::IfThenElse(ends, left, cut.left_of_end);
}

// Whether both values are outside.
HWY_INLINE M both_out(V f0, V f1) { return hn::Lt(hn::Max(f0, f1), hn::Zero(kTag)); }

// How far along the outline of the square the ray from its centre leaves it: from (1, 0),
// counter-clockwise, [-1, 7]; 0 at the centre itself.
HWY_INLINE V perimeter(V u, V v) {
  const V zero = hn::Zero(kTag);
  const M sideways = hn::Ge(hn::Abs(u), hn::Abs(v));
  const V numerator = hn::IfThenElse(sideways, v, u);
  const V denominator = hn::IfThenElse(sideways, u, v);
  const V ratio = hn::Div(numerator, denominator);
  const V side = hn::Add(hn::IfThenElseZero(hn::Lt(u, zero), set(4.0F)), ratio);
  const V ends = hn::Sub(hn::IfThenElse(hn::Lt(v, zero), set(6.0F), set(2.0F)), ratio);
  return hn::IfThenElse(hn::Eq(denominator, zero), zero, hn::IfThenElse(sideways, side, ends));
}

// The edge as a point sees it against a rectangular light, clipped to the light: homogeneous, in
// half axes of the light.
struct SeenEdge {
  V pu, pv, pw, qu, qv, qw;
  M alive;  // a part of it is before the light
};

// \param forms  u, v, w of the edge's begin, then of its end, on the light's plane
HWY_INLINE SeenEdge see_edge(const V* forms) {
  const V u0 = forms[0];
  const V v0 = forms[1];
  const V w0 = forms[2];
  const V u1 = forms[3];
  const V v1 = forms[4];
  const V w1 = forms[5];
  SeenEdge seen{u0, v0, w0, u1, v1, w1, hn::Eq(w0, w0)};
  const V a0 = hn::Sub(w0, u0);
  const V a1 = hn::Sub(w1, u1);
  const V b0 = hn::Add(w0, u0);
  const V b1 = hn::Add(w1, u1);
  const V c0 = hn::Sub(w0, v0);
  const V c1 = hn::Sub(w1, v1);
  const V d0 = hn::Add(w0, v0);
  const V d1 = hn::Add(w1, v1);
  const M beside = hn::Or(hn::Or(both_out(a0, a1), both_out(b0, b1)),
                          hn::Or(both_out(c0, c1), both_out(d0, d1)));
  seen.alive = hn::Not(beside);
  if (hn::AllFalse(kTag, seen.alive)) return seen;
  const V one = set(1.0F);
  Cut cut{hn::Zero(kTag), one, hn::Zero(kTag), one};
  clip(a0, a1, cut);
  clip(b0, b1, cut);
  clip(c0, c1, cut);
  clip(d0, d1, cut);
  seen.alive = hn::And(seen.alive, hn::Lt(hn::Add(cut.begin, cut.end), one));
  const auto first = [&](V at0, V at1) HWY_ATTR {
    return hn::Add(hn::Mul(cut.left_of_begin, at0), hn::Mul(cut.begin, at1));
  };
  const auto last = [&](V at0, V at1) HWY_ATTR {
    return hn::Add(hn::Mul(cut.end, at0), hn::Mul(cut.left_of_end, at1));
  };
  seen.pu = first(u0, u1);
  seen.pv = first(v0, v1);
  seen.pw = first(w0, w1);
  seen.qu = last(u0, u1);
  seen.qv = last(v0, v1);
  seen.qw = last(w0, w1);
  return seen;
}

/// Exact clipping on a rectangular light (Paper III, 3.2.2): the area between the rays from its
/// centre through the clipped ends, by their exits on its outline, less the triangle before them.
struct RectangleShare {
  static constexpr std::size_t kForms = 6;
  static constexpr std::size_t kChannels = 1;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge&, M inner, V* shares, M&) const {
    const V zero = hn::Zero(kTag);
    const SeenEdge seen = see_edge(forms);
    if (hn::AllFalse(kTag, seen.alive)) return seen.alive;
    const V w = hn::Mul(seen.pw, seen.qw);
    V turn = hn::Sub(perimeter(seen.qu, seen.qv), perimeter(seen.pu, seen.pv));
    turn = hn::IfThenElse(hn::Gt(turn, set(4.0F)), hn::Sub(turn, set(8.0F)), turn);
    turn = hn::IfThenElse(hn::Lt(turn, set(-4.0F)), hn::Add(turn, set(8.0F)), turn);
    const V cross = hn::Div(hn::Sub(hn::Mul(seen.pu, seen.qv), hn::Mul(seen.pv, seen.qu)), w);
    const V covered = hn::Mul(hn::Abs(hn::Sub(turn, cross)), set(0.125F));
    shares[0] = hn::IfThenElse(inner, covered, hn::Neg(covered));
    return hn::And(seen.alive, hn::Gt(w, zero));
  }
};

// The angle of (x, y), y ≥ 0, in [0, π]; within 3e-7.
HWY_INLINE V upper_angle(V y, V x) {
  constexpr float kPi = 3.14159265F;
  const V zero = hn::Zero(kTag);
  const V ax = hn::Abs(x);
  const M steep = hn::Lt(ax, y);
  const V small = hn::Min(ax, y);
  const V large = hn::Max(ax, y);
  const M shift = hn::Gt(small, hn::Mul(set(0.414213562F), large));
  const V r = hn::Div(hn::IfThenElse(shift, hn::Sub(small, large), small),
                      hn::IfThenElse(shift, hn::Add(small, large), large));
  const V w = hn::Mul(r, r);
  // The polynomial of Cephes' atanf, for |r| ≤ tan(π/8).
  V p = set(0.0805374449538F);
  p = hn::Add(hn::Mul(p, w), set(-0.138776856032F));
  p = hn::Add(hn::Mul(p, w), set(0.199777106478F));
  p = hn::Add(hn::Mul(p, w), set(-0.333329491539F));
  const V atan = hn::Add(r, hn::Mul(hn::Mul(r, w), p));
  V angle = hn::Add(atan, hn::IfThenElseZero(shift, set(0.25F * kPi)));
  angle = hn::IfThenElse(steep, hn::Sub(set(0.5F * kPi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(set(kPi), angle), angle);
  return hn::IfThenElse(hn::Eq(large, zero), zero, angle);
}

/// A spherical light (Paper IV, 4.2.1): the segment that the edge cuts from the disc of the tangent
/// cone. Forms: along the edge, out from the centre to its line, across both, w, then what is left
/// to the line beyond the point (w·distance − out) and along it to the ends (w·end − along).
/// Constants: the line's distance from the centre and the ends along it, in radii.
struct SphereShare {
  static constexpr std::size_t kForms = 7;
  static constexpr std::size_t kChannels = 1;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M inner, V* shares, M&) const {
    const auto& constants = wedge.constants;
    const V zero = hn::Zero(kTag);
    const V one = set(1.0F);
    const V along = forms[0];
    const V out = forms[1];
    const V normal = forms[2];
    const V w = forms[3];
    const V beyond = forms[4];
    const V distance = set(constants[0]);
    const V normal2 = hn::Mul(normal, normal);
    const V w2 = hn::Mul(w, w);
    const V radius2 = hn::Add(hn::Add(hn::Mul(along, along), hn::Mul(out, out)), normal2);
    const V tangent2 = hn::Sub(radius2, w2);
    const V reach2 = hn::Add(normal2, hn::Mul(beyond, beyond));
    // Of the line's projection from the centre of the disc, squared, in radii of the disc.
    const V height2 = hn::Div(hn::Mul(hn::Mul(distance, distance), normal2), reach2);
    M alive = hn::And(hn::Gt(tangent2, zero), hn::Gt(reach2, zero));
    alive = hn::And(alive, hn::Lt(height2, one));
    if (hn::AllFalse(kTag, alive)) return alive;
    const V limit = hn::Sqrt(hn::Div(hn::Mul(hn::Sub(one, height2), w2), tangent2));
    const V reach = hn::Sqrt(reach2);
    const V axial_out = hn::Sub(normal2, hn::Mul(out, beyond));
    const V ends[2] = {set(constants[1]), set(constants[2])};
    // Tangents of the ends' angles from the line's nearest point, seen from the disc's centre.
    V tangents[2] = {hn::Neg(limit), limit};
    M ahead = hn::Lt(one, zero);
    for (std::size_t i = 0; i < 2; ++i) {
      const V left = forms[5 + i];
      const V axial = hn::Sub(axial_out, hn::Mul(along, left));
      const M is_ahead = hn::Gt(axial, zero);
      ahead = hn::Or(ahead, is_ahead);
      const V turn = hn::Sub(hn::Mul(beyond, ends[i]), hn::Mul(distance, left));
      const V sideways = hn::Mul(w, hn::Add(hn::Mul(normal2, ends[i]), hn::Mul(beyond, turn)));
      const V tangent = hn::Div(sideways, hn::Mul(reach, axial));
      const V limited = hn::Max(hn::Neg(limit), hn::Min(limit, tangent));
      tangents[i] = hn::IfThenElse(is_ahead, limited, tangents[i]);
    }
    alive = hn::And(alive, hn::And(ahead, hn::Lt(tangents[0], tangents[1])));
    const V point2 = hn::Div(radius2, w2);
    const V length = hn::Mul(hn::Sqrt(hn::Mul(height2, point2)), hn::Sub(tangents[1], tangents[0]));
    const V inline_part = hn::Add(height2, hn::Mul(point2, hn::Mul(tangents[0], tangents[1])));
    const V triangle = hn::Div(hn::Mul(length, tangent2), hn::Sub(radius2, hn::Mul(height2, w2)));
    const V area = hn::Sub(upper_angle(length, inline_part), triangle);
    const V covered = hn::Max(zero, hn::Mul(area, set(0.159154943F)));
    shares[0] = hn::IfThenElse(inner, covered, hn::Neg(covered));
    return alive;
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_COVERAGE_SIMD_H
