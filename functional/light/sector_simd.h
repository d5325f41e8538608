// What an edge covers by Paper IV's tables (shader_tables.h), for the lanes of a vector at once.
// Compiled once for every instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_SECTOR_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_SECTOR_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_SECTOR_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_SECTOR_SIMD_H
#endif

#include "functional/light/chord_simd.h"
#include "functional/light/shader_tables.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

// AngleMap::angle, whatever a lane holds that does not count.
HWY_INLINE V looked_up_angle(const SectorTable& table, V x, V y) {
  const V zero = hn::Zero(kTag);
  const M in_x = hn::Ge(hn::Abs(x), hn::Abs(y));
  const V major = hn::IfThenElse(in_x, x, y);
  const V minor = hn::IfThenElse(in_x, y, x);
  constexpr float kSide = AngleMap::kSide;
  const V at = hn::Mul(hn::Add(hn::Div(minor, hn::Abs(major)), set(1.0F)), set(0.5F * kSide));
  const V texel = hn::Min(hn::IfThenElseZero(hn::Ge(at, zero), at), set(kSide - 1.0F));
  const V face = hn::Add(hn::IfThenElseZero(hn::Not(in_x), set(2.0F * kSide)),
                         hn::IfThenElseZero(hn::Lt(major, zero), set(kSide)));
  const I index = hn::ConvertTo(kInts, hn::Add(hn::Floor(texel), face));
  return hn::GatherIndex(kTag, table.angles().texels(), index);
}

// The two entries about an angle, and how near the second is.
struct SectorPlace {
  explicit HWY_INLINE SectorPlace(V angle) {
    constexpr float kSide = SectorTable::kSide;
    constexpr float kPerRadian = kSide / 6.28318531F;
    const V at = hn::Add(hn::Mul(angle, set(kPerRadian)), set(0.5F * kSide - 0.5F));
    const V low = hn::Floor(at);
    const I last = hn::Set(kInts, SectorTable::kSide - 1);
    first = hn::And(hn::ConvertTo(kInts, low), last);  // all the way round
    second = hn::And(hn::Add(first, hn::Set(kInts, 1)), last);
    weight = hn::Sub(at, low);
  }
  I first, second;
  V weight;
};

HWY_INLINE V mixed(V a, V b, V weight) { return hn::Add(a, hn::Mul(weight, hn::Sub(b, a))); }

// SectorTable::coverage.
HWY_INLINE V sector_coverage(const SectorTable& table, const Chords& chords) {
  const SectorPlace p(looked_up_angle(table, chords.px, chords.py));
  const SectorPlace q(looked_up_angle(table, chords.qx, chords.qy));
  const auto row = [&](I j) HWY_ATTR {
    const I begin = hn::Mul(j, hn::Set(kInts, SectorTable::kSide));
    return mixed(hn::GatherIndex(kTag, table.areas(), hn::Add(begin, p.first)),
                 hn::GatherIndex(kTag, table.areas(), hn::Add(begin, p.second)), p.weight);
  };
  const V sector = mixed(row(q.first), row(q.second), q.weight);
  const V part = hn::Mul(hn::Sub(sector, hn::Mul(set(0.5F), hn::Abs(chords.cross()))),
                         set(1.0F / table.light_area()));
  return hn::Min(hn::Max(part, hn::Zero(kTag)), set(0.5F));
}

/// A rectangular light (Paper IV, 4.2.2).
struct SquareLookup {
  static constexpr std::size_t kChannels = 1;
  const SectorTable& square;
  HWY_INLINE void operator()(const Chords& chords, M, V* parts) const {
    parts[0] = sector_coverage(square, chords);
  }
};
using RectangleTableShare = ChordShare<SquareLookup>;

struct V3 {
  V x, y, z;
};
HWY_INLINE V dot(const V3& a, const V3& b) {
  return hn::Add(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}
HWY_INLINE V3 scaled(const V3& a, V by) {
  return {hn::Mul(a.x, by), hn::Mul(a.y, by), hn::Mul(a.z, by)};
}
HWY_INLINE V3 minus(const V3& a, const V3& b) {
  return {hn::Sub(a.x, b.x), hn::Sub(a.y, b.y), hn::Sub(a.z, b.z)};
}

// Across (across.h): the same axes for all edges at a point, whose lookups then round alike.
struct ConeAxes {
  // \param axis  unit
  explicit HWY_INLINE ConeAxes(const V3& axis) {
    const V zero = hn::Zero(kTag);
    const M by_x = hn::Lt(hn::Abs(axis.x), set(0.6F));
    const V3 side{hn::IfThenElse(by_x, zero, hn::Neg(axis.z)), hn::IfThenElse(by_x, axis.z, zero),
                  hn::IfThenElse(by_x, hn::Neg(axis.y), axis.x)};
    u = scaled(side, hn::Div(set(1.0F), hn::Sqrt(dot(side, side))));
    v = {hn::Sub(hn::Mul(axis.y, u.z), hn::Mul(axis.z, u.y)),
         hn::Sub(hn::Mul(axis.z, u.x), hn::Mul(axis.x, u.z)),
         hn::Sub(hn::Mul(axis.x, u.y), hn::Mul(axis.y, u.x))};
  }
  V3 u, v;
};

HWY_INLINE V cone_form(const V3& a, const V3& b) {
  return hn::Sub(hn::Add(hn::Mul(a.x, b.x), hn::Mul(a.y, b.y)), hn::Mul(a.z, b.z));
}

// The part [first, last] of a segment, 0 at its begin and 1 at its end.
struct Clipped {
  V first, last;
  M alive;
};

// The part of a segment a + s·way in the cone x² + y² ≤ z², z > 0; see shader_sphere_coverage.
HWY_INLINE Clipped clip_by_cone(const V3& a, const V3& way, M alive) {
  const V zero = hn::Zero(kTag);
  const V aa = cone_form(way, way);
  const V ab = cone_form(a, way);
  const V bb = cone_form(a, a);
  const V root = hn::Sub(hn::Mul(ab, ab), hn::Mul(aa, bb));
  Clipped part{zero, set(1.0F), hn::And(alive, hn::Gt(root, zero))};
  if (hn::AllFalse(kTag, part.alive)) return part;
  const V reach = hn::Sqrt(root);
  const V sum = hn::Neg(hn::Add(ab, hn::IfThenElse(hn::Lt(ab, zero), hn::Neg(reach), reach)));
  const V s0 = hn::Div(sum, aa);
  const V s1 = hn::Div(bb, sum);
  const V less = hn::Min(s0, s1);
  const V more = hn::Max(s0, s1);
  const M shallow = hn::Gt(aa, zero);
  const M upward = hn::Gt(way.z, zero);
  const V enters = hn::IfThenElse(shallow, less, hn::IfThenElse(upward, more, zero));
  const V leaves = hn::IfThenElse(shallow, more, hn::IfThenElse(upward, part.last, less));
  part.first = hn::Max(part.first, enters);
  part.last = hn::Min(part.last, leaves);
  part.alive = hn::And(part.alive, hn::Lt(part.first, part.last));
  return part;
}

/// A spherical light (Paper IV, 4.2.1): the edge clipped by the cone through the light's disc, then
/// the tables. Forms: cone_forms (coverage_forms.h).
struct SphereTableShare {
  static constexpr std::size_t kForms = 7;
  static constexpr std::size_t kChannels = 1;
  const SectorTable& disc;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M inner, V* shares, M&) const {
    const V zero = hn::Zero(kTag);
    // Homogeneous: everything times w.
    const V3 to_begin{forms[0], forms[1], forms[2]};
    const V3 to_end{forms[3], forms[4], forms[5]};
    const V w = forms[6];
    const V3 begin{set(wedge.constants[0]), set(wedge.constants[1]), set(wedge.constants[2])};
    const V3 to_centre = minus(to_begin, scaled(begin, w));
    const V distance2 = dot(to_centre, to_centre);
    const M outside = hn::Gt(distance2, hn::Mul(w, w));
    const V to_unit = hn::Div(set(1.0F), hn::Sqrt(distance2));
    const V3 axis = scaled(to_centre, to_unit);
    const ConeAxes axes(axis);
    // The point at the origin, the light's centre at z = 1, its radius 1: the cone is x² + y² = z².
    const V shrink = hn::Mul(w, to_unit);
    const auto in_cone = [&](const V3& way) HWY_ATTR {
      return V3{dot(way, axes.u), dot(way, axes.v), hn::Mul(dot(way, axis), shrink)};
    };
    const V3 a = in_cone(to_begin);
    const V3 way = minus(in_cone(to_end), a);
    const Clipped part = clip_by_cone(a, way, outside);
    if (hn::AllFalse(kTag, part.alive)) return part.alive;
    const auto at = [&](V s) HWY_ATTR {
      return V3{hn::Add(a.x, hn::Mul(s, way.x)), hn::Add(a.y, hn::Mul(s, way.y)),
                hn::Add(a.z, hn::Mul(s, way.z))};
    };
    const V3 p = at(part.first);
    const V3 q = at(part.last);
    const Chords chords{hn::Div(p.x, p.z), hn::Div(p.y, p.z), hn::Div(q.x, q.z), hn::Div(q.y, q.z)};
    shares[0] = signed_share(inner, sector_coverage(disc, chords));
    return hn::And(part.alive, hn::And(hn::Gt(p.z, zero), hn::Gt(q.z, zero)));
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_SECTOR_SIMD_H
