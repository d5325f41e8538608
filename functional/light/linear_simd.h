// The light intensity in a wedge by interpolation between its planes (Papers I and II), in single
// precision, for the lanes of a vector at once. Compiled once for every instruction set, as Highway
// has it.
#if defined(WEDGESIM_FUNCTIONAL_LIGHT_LINEAR_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_LIGHT_LINEAR_SIMD_H
#undef WEDGESIM_FUNCTIONAL_LIGHT_LINEAR_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_LIGHT_LINEAR_SIMD_H
#endif

#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

// What the forms of a linear wedge are: its planes, inwards. Unused forms are 1 everywhere.
constexpr std::size_t kFront = 0;
constexpr std::size_t kBack = 1;
constexpr std::size_t kLeft = 2;
constexpr std::size_t kRight = 3;
constexpr std::size_t kLinearForms = 8;

// Paper I, Eqs. 1-3, over one denominator. The constants are LinearWedge::factors.
HWY_INLINE V linear_intensity(const V* forms, const float* factors, bool cubic) {
  const V zero = hn::Zero(kTag);
  const V one = set(1.0F);
  const V back_left = hn::Mul(forms[kBack], set(factors[1]));
  const V back_right = hn::Mul(forms[kBack], set(factors[3]));
  const V thick_left = hn::Add(hn::Mul(forms[kFront], set(factors[0])), back_left);
  const V thick_right = hn::Add(hn::Mul(forms[kFront], set(factors[2])), back_right);
  const V to_left = hn::Mul(forms[kLeft], set(factors[4]));
  const V to_right = hn::Mul(forms[kRight], set(factors[5]));
  const V numerator = hn::Add(hn::Mul(hn::Mul(to_right, back_left), thick_right),
                              hn::Mul(hn::Mul(to_left, back_right), thick_left));
  const V denominator = hn::Mul(hn::Mul(thick_left, thick_right), hn::Add(to_right, to_left));
  V s = hn::Max(zero, hn::Min(one, hn::Div(numerator, denominator)));
  s = hn::IfThenElse(hn::Eq(denominator, zero), set(0.5F), s);
  if (!cubic) return s;
  return hn::Mul(hn::Mul(s, s), hn::Sub(set(3.0F), hn::Mul(set(2.0F), s)));
}

// As the 16-bit buffer holds it: whole 255ths.
HWY_INLINE V whole_255ths(V s) {
  return hn::Mul(hn::Round(hn::Mul(s, set(255.0F))), set(1.0F / 255.0F));
}

// Inside all planes; a point on a plane that two wedges share is in one of them.
HWY_INLINE M inside_all(const V* forms, const ScreenWedge& wedge) {
  const V zero = hn::Zero(kTag);
  M inside = hn::Eq(zero, zero);
  for (std::size_t i = 0; i < kLinearForms; ++i) {
    const bool owns_plane = wedge.forms[i].x >= 0.0;
    inside = hn::And(inside, owns_plane ? hn::Ge(forms[i], zero) : hn::Gt(forms[i], zero));
  }
  return inside;
}

/// Paper II, 3: points inside the wedge get its intensity; umbra polygons take the rest.
struct RestructuredShare {
  static constexpr std::size_t kForms = kLinearForms;
  static constexpr std::size_t kChannels = 1;
  bool cubic = false;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M, V* shares, M&) const {
    const M inside = inside_all(forms, wedge);
    if (hn::AllFalse(kTag, inside)) return inside;
    shares[0] = whole_255ths(linear_intensity(forms, wedge.constants.data(), cubic));
    return inside;
  }
};

/// Paper I, 4 and 5: the intensity where the eye's ray leaves the wedge or at the point in it, less
/// that where it enters: 1 on the front plane, 0 on the back plane, and nothing on other planes,
/// where the neighbour's cancels it.
struct EntryExitShare {
  static constexpr std::size_t kForms = kLinearForms;
  static constexpr std::size_t kChannels = 1;
  bool cubic = false;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M, V* shares, M& read) const {
    const V zero = hn::Zero(kTag);
    const V one = set(1.0F);
    // Depths from the point's to where its ray enters and leaves, and the intensities there.
    V entry = set(-1e30F);
    V exit = set(1e30F);
    V at_entry = zero;
    V at_exit = zero;
    M hit = hn::Eq(zero, zero);
    for (std::size_t i = 0; i < kLinearForms; ++i) {
      const auto slope = static_cast<float>(wedge.forms[i].z);
      const V intensity = i == kFront ? one : zero;
      if (slope == 0.0F) {
        hit = hn::And(hit, hn::Ge(forms[i], zero));
        continue;
      }
      const V depth = hn::Div(forms[i], set(-slope));
      if (slope > 0.0F) {
        const M later = hn::Gt(depth, entry);
        entry = hn::IfThenElse(later, depth, entry);
        at_entry = hn::IfThenElse(later, intensity, at_entry);
      } else {
        const M sooner = hn::Lt(depth, exit);
        exit = hn::IfThenElse(sooner, depth, exit);
        at_exit = hn::IfThenElse(sooner, intensity, at_exit);
      }
    }
    // A fragment of the front-facing polygons, whether the surface hides it or not.
    read = hn::And(hit, hn::Lt(entry, exit));
    hit = hn::And(read, hn::Le(entry, zero));
    if (hn::AllFalse(kTag, hit)) return hit;
    const M inside = hn::Gt(exit, zero);
    const V at_point = linear_intensity(forms, wedge.constants.data(), cubic);
    shares[0] = whole_255ths(hn::Sub(hn::IfThenElse(inside, at_point, at_exit), at_entry));
    return hit;
  }
};

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_LIGHT_LINEAR_SIMD_H
