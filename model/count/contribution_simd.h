// What a wedge hides of its light, for the lanes of a vector at once: contribution.cpp, the same
// operations in the same order. Compiled once for every instruction set, as Highway has it.
#if defined(WEDGESIM_MODEL_COUNT_CONTRIBUTION_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_MODEL_COUNT_CONTRIBUTION_SIMD_H
#undef WEDGESIM_MODEL_COUNT_CONTRIBUTION_SIMD_H
#else
#define WEDGESIM_MODEL_COUNT_CONTRIBUTION_SIMD_H
#endif

#include <array>

#include "hwy/highway.h"
#include "model/count/atan.h"
#include "model/count/kernel.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::model {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<double, kBlock>;  // lanes never straddle a block's row
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D kTag;
constexpr hn::RebindToSigned<D> kIntTag;

V set(double value) { return hn::Set(kTag, value); }

// The groups of lanes of a block's row.
constexpr std::size_t kLanes = hn::MaxLanes(kTag);
constexpr std::size_t kGroups = kBlock / kLanes;
constexpr std::uint64_t kGroupBits = (std::uint64_t{1} << kLanes) - 1;

// A value linear in x, y and z, over one block: a*x of its 8 columns and b*y of its 8 rows are
// kept.
struct BlockRow {
  std::array<double, kBlock> ax, by;
  double c, d;

  HWY_INLINE void place(const Row& row, const Block& block) {
    for (std::size_t k = 0; k < kBlock; k += kLanes) {
      const V centre = hn::Add(hn::Iota(kTag, static_cast<double>(k)), set(0.5));
      const V x = hn::Add(set(block.bx * 8.0), centre);
      const V y = hn::Add(set(block.by * 8.0), centre);
      hn::StoreU(hn::Mul(set(row.a), x), kTag, &ax[k]);
      hn::StoreU(hn::Mul(set(row.b), y), kTag, &by[k]);
    }
    c = row.c;
    d = row.d;
  }
  HWY_INLINE V value(std::size_t row, std::size_t group, V z) const {
    const V ab = hn::Add(hn::LoadU(kTag, &ax[group * kLanes]), set(by[row]));
    return hn::Add(hn::Add(ab, hn::Mul(set(c), z)), set(d));
  }
};

// What is linear in x, y and z, at one group of lanes of a block.
struct Here {
  const BlockRow* rows;
  std::size_t row, group;
  V z;
  HWY_INLINE V operator()(std::size_t i) const { return rows[i].value(row, group, z); }
};

std::array<Row, 4> rows_of(const LinearTerms& terms) {
  // Turned inwards: that changes no bit of a value but its sign.
  std::array<Row, 4> rows;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Plane& plane = terms.planes[i];
    const double sign = plane.minus ? -1.0 : 1.0;
    rows[i] = {sign * plane.a, sign * plane.b, sign * plane.c, sign * plane.d};
  }
  return rows;
}
std::array<Row, 6> rows_of(const RectangleTerms& terms) {
  const auto& [p, q] = terms.ends;
  return {p.u, p.v, p.w, q.u, q.v, q.w};
}
std::array<Row, 4> rows_of(const SphereTerms& terms) {
  return {terms.along, terms.out, terms.normal, terms.w};
}

V value_of(const LinearTerms& terms, const Here& here) {
  const V front = here(0);
  const V back = here(1);
  const V left = here(2);
  const V right = here(3);
  const V back_left = hn::Mul(back, set(terms.factors[1]));
  const V back_right = hn::Mul(back, set(terms.factors[3]));
  const V thick_left = hn::Add(hn::Mul(front, set(terms.factors[0])), back_left);
  const V thick_right = hn::Add(hn::Mul(front, set(terms.factors[2])), back_right);
  const V to_left = hn::Mul(left, set(terms.factors[4]));
  const V to_right = hn::Mul(right, set(terms.factors[5]));
  const V numerator = hn::Add(hn::Mul(hn::Mul(to_right, back_left), thick_right),
                              hn::Mul(hn::Mul(to_left, back_right), thick_left));
  const V denominator = hn::Mul(hn::Mul(thick_left, thick_right), hn::Add(to_right, to_left));
  const V zero = hn::Zero(kTag);
  const V one = set(1.0);
  const V s = hn::Div(numerator, denominator);
  const V clamped = hn::IfThenElse(hn::Lt(s, zero), zero, hn::IfThenElse(hn::Gt(s, one), one, s));
  return hn::IfThenElse(hn::Eq(denominator, zero), set(0.5), clamped);
}

struct Cut {
  V begin, left_of_begin, end, left_of_end;
  M alive;
};

void clip(V f0, V f1, Cut& cut) {
  const V zero = hn::Zero(kTag);
  const M out0 = hn::Lt(f0, zero);
  const M out1 = hn::Lt(f1, zero);
  // Of the end that is outside; both are in lanes that are not alive.
  const V per_length = hn::Div(set(1.0), hn::Sub(f0, f1));
  const V share = hn::Mul(hn::IfThenElse(out0, f0, hn::Neg(f1)), per_length);
  const V left = hn::Mul(hn::IfThenElse(out0, hn::Neg(f1), f0), per_length);
  const M begins = hn::And(out0, hn::Gt(share, cut.begin));
  const M ends = hn::And(out1, hn::Gt(share, cut.end));
  cut.alive = hn::AndNot(hn::And(out0, out1), cut.alive);
  cut.begin = hn::IfThenElse(begins, share, cut.begin);
  cut.left_of_begin = hn::IfThenElse(begins, left, cut.left_of_begin);
  cut.end = hn::IfThenElse(ends, share, cut.end);
  cut.left_of_end = hn::IfThenElse(ends, left, cut.left_of_end);
}

V perimeter(V u, V v) {
  const V zero = hn::Zero(kTag);
  const M sideways = hn::Ge(hn::Abs(u), hn::Abs(v));
  const V numerator = hn::IfThenElse(sideways, v, u);
  const V denominator = hn::IfThenElse(sideways, u, v);
  const V ratio = hn::Div(numerator, denominator);
  const V side = hn::Add(hn::IfThenElse(hn::Lt(u, zero), set(4.0), zero), ratio);
  const V ends = hn::Sub(hn::IfThenElse(hn::Lt(v, zero), set(6.0), set(2.0)), ratio);
  return hn::IfThenElse(hn::Eq(denominator, zero), zero, hn::IfThenElse(sideways, side, ends));
}

// share0 at0 + share1 at1
V between(V share0, V at0, V share1, V at1) {
  return hn::Add(hn::Mul(share0, at0), hn::Mul(share1, at1));
}

V value_of(const RectangleTerms&, const Here& here) {
  const V u0 = here(0);
  const V v0 = here(1);
  const V w0 = here(2);
  const V u1 = here(3);
  const V v1 = here(4);
  const V w1 = here(5);
  const V zero = hn::Zero(kTag);
  const V one = set(1.0);
  Cut cut{zero, one, zero, one, hn::Eq(zero, zero)};
  clip(hn::Sub(w0, u0), hn::Sub(w1, u1), cut);
  clip(hn::Add(w0, u0), hn::Add(w1, u1), cut);
  clip(hn::Sub(w0, v0), hn::Sub(w1, v1), cut);
  clip(hn::Add(w0, v0), hn::Add(w1, v1), cut);
  cut.alive = hn::And(cut.alive, hn::Lt(hn::Add(cut.begin, cut.end), one));
  const auto first = [&](V at0, V at1)
                         HWY_ATTR { return between(cut.left_of_begin, at0, cut.begin, at1); };
  const auto last = [&](V at0, V at1)
                        HWY_ATTR { return between(cut.end, at0, cut.left_of_end, at1); };
  const V pu = first(u0, u1);
  const V pv = first(v0, v1);
  const V qu = last(u0, u1);
  const V qv = last(v0, v1);
  const V w = hn::Mul(first(w0, w1), last(w0, w1));
  cut.alive = hn::And(cut.alive, hn::Gt(w, zero));
  V turn = hn::Sub(perimeter(qu, qv), perimeter(pu, pv));
  turn = hn::IfThenElse(hn::Gt(turn, set(4.0)), hn::Sub(turn, set(8.0)), turn);
  turn = hn::IfThenElse(hn::Lt(turn, set(-4.0)), hn::Add(turn, set(8.0)), turn);
  const V cross = hn::Div(hn::Sub(hn::Mul(pu, qv), hn::Mul(pv, qu)), w);
  return hn::IfThenElseZero(cut.alive, hn::Mul(hn::Abs(hn::Sub(turn, cross)), set(0.125)));
}

V upper_angles(V y, V x) {
  const V zero = hn::Zero(kTag);
  const V ax = hn::Abs(x);
  const M steep = hn::Lt(ax, y);
  const V small = hn::IfThenElse(steep, ax, y);
  const V large = hn::IfThenElse(steep, y, ax);
  const M shift = hn::Gt(small, hn::Mul(set(kTanEighthPi), large));
  const V r = hn::Div(hn::IfThenElse(shift, hn::Sub(small, large), small),
                      hn::IfThenElse(shift, hn::Add(small, large), large));
  const V w = hn::Mul(r, r);
  V p = set(kAtanCoefficients.back());
  for (std::size_t i = kAtanCoefficients.size() - 1; i-- > 0;) {
    p = hn::Add(hn::Mul(p, w), set(kAtanCoefficients[i]));
  }
  V angle = hn::Add(hn::Mul(r, p), hn::IfThenElse(shift, set(kQuarterPi), zero));
  angle = hn::IfThenElse(steep, hn::Sub(set(kHalfPi), angle), angle);
  angle = hn::IfThenElse(hn::Lt(x, zero), hn::Sub(set(kPi), angle), angle);
  return hn::IfThenElse(hn::Eq(large, zero), zero, angle);
}

V value_of(const SphereTerms& terms, const Here& here) {
  const V zero = hn::Zero(kTag);
  const V one = set(1.0);
  const V along_edge = here(0);
  const V out = here(1);
  const V normal = here(2);
  const V w = here(3);
  const V distance = set(terms.distance);
  const V beyond = hn::Sub(hn::Mul(w, distance), out);
  const V normal2 = hn::Mul(normal, normal);
  const V w2 = hn::Mul(w, w);
  const V radius2 = hn::Add(hn::Add(hn::Mul(along_edge, along_edge), hn::Mul(out, out)), normal2);
  const V tangent2 = hn::Sub(radius2, w2);
  const V reach2 = hn::Add(normal2, hn::Mul(beyond, beyond));
  const V height2 = hn::Div(hn::Mul(set(terms.distance_squared), normal2), reach2);
  M alive = hn::And(hn::Gt(tangent2, zero), hn::Gt(reach2, zero));
  alive = hn::And(alive, hn::Lt(height2, one));
  const V limit = hn::Sqrt(hn::Div(hn::Mul(hn::Sub(one, height2), w2), tangent2));
  const V reach = hn::Sqrt(reach2);
  const V axial_out = hn::Sub(normal2, hn::Mul(out, beyond));
  const V back = hn::Neg(limit);
  M ahead = hn::Lt(one, zero);
  const auto tangent_of = [&](double end, V otherwise) HWY_ATTR {
    const V at = set(end);
    const V axial = hn::Sub(axial_out, hn::Mul(along_edge, hn::Sub(hn::Mul(w, at), along_edge)));
    const M is_ahead = hn::Gt(axial, zero);
    ahead = hn::Or(ahead, is_ahead);
    const V turn = hn::Sub(hn::Mul(along_edge, distance), hn::Mul(out, at));
    const V sideways = hn::Mul(w, hn::Add(hn::Mul(normal2, at), hn::Mul(beyond, turn)));
    const V tangent = hn::Div(sideways, hn::Mul(reach, axial));
    const V limited = hn::IfThenElse(hn::Lt(tangent, back), back,
                                     hn::IfThenElse(hn::Gt(tangent, limit), limit, tangent));
    return hn::IfThenElse(is_ahead, limited, otherwise);
  };
  const V first = tangent_of(terms.ends[0], back);
  const V last = tangent_of(terms.ends[1], limit);
  alive = hn::And(alive, hn::And(ahead, hn::Lt(first, last)));
  const V point2 = hn::Div(radius2, w2);
  const V length = hn::Mul(hn::Sqrt(hn::Mul(height2, point2)), hn::Sub(last, first));
  const V inline_part = hn::Add(height2, hn::Mul(point2, hn::Mul(first, last)));
  const V triangle = hn::Div(hn::Mul(length, tangent2), hn::Sub(radius2, hn::Mul(height2, w2)));
  const V area = hn::Sub(upper_angles(length, inline_part), triangle);
  return hn::IfThenElseZero(alive, hn::Mul(area, set(0.5 / kPi)));
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::model
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_MODEL_COUNT_CONTRIBUTION_SIMD_H
