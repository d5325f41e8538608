// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/chord_kernel.h"

#include <algorithm>
#include <bit>
#include <utility>

#include "functional/light/split_word.h"
#include "functional/methods/ssv_kernel.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/chord_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/light/coverage_simd.h"
#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

// Clipping as RectangleShare, then a lookup at each point.
template <std::size_t channels>
struct ChordShare {
  static constexpr std::size_t kForms = RectangleShare::kForms;
  static constexpr std::size_t kChannels = channels;
  const ChordLookup& lookup;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge&, M inner, V* shares, M&) const {
    const SeenEdge seen = see_edge(forms);
    if (hn::AllFalse(kTag, seen.alive)) return seen.alive;
    const V zero = hn::Zero(kTag);
    const M counts = hn::And(seen.alive, hn::And(hn::Gt(seen.pw, zero), hn::Gt(seen.qw, zero)));
    float ends[4][kLanes];
    hn::StoreU(hn::Div(seen.pu, seen.pw), kTag, ends[0]);
    hn::StoreU(hn::Div(seen.pv, seen.pw), kTag, ends[1]);
    hn::StoreU(hn::Div(seen.qu, seen.qw), kTag, ends[2]);
    hn::StoreU(hn::Div(seen.qv, seen.qw), kTag, ends[3]);
    float parts[3][kLanes] = {};
    for (std::uint64_t left = bits_of(counts); left != 0; left &= left - 1) {
      const auto i = static_cast<std::size_t>(std::countr_zero(left));
      const std::array<float, 3> part =
          lookup(glm::dvec2(ends[0][i], ends[1][i]), glm::dvec2(ends[2][i], ends[3][i]));
      for (std::size_t c = 0; c < channels; ++c) parts[c][i] = part[c];
    }
    for (std::size_t c = 0; c < channels; ++c) {
      const V part = hn::LoadU(kTag, parts[c]);
      shares[c] = hn::IfThenElse(inner, part, hn::Neg(part));
    }
    return counts;
  }
};

template <typename Share>
struct ShortShare {
  static constexpr std::size_t kForms = Share::kForms;
  static constexpr std::size_t kChannels = 3;
  static constexpr std::size_t kUmbraChannel = 2;
  static constexpr std::size_t kWords = 1;  // one component is blended at a time
  Share share;

  HWY_INLINE M operator()(const V* forms, const ScreenWedge& wedge, M inner, V* shares,
                          M& read) const {
    const V zero = hn::Zero(kTag);
    V whole = zero;
    const M counts = share(forms, wedge, inner, &whole, read);
    const V levels = set(static_cast<float>(ShortWord::kWhole));
    const V level = hn::Floor(hn::Add(hn::Mul(hn::Abs(whole), levels), set(0.5F)));
    const V word = hn::Mul(level, set(1.0F / 64.0F));
    shares[0] = hn::IfThenElse(inner, word, zero);
    shares[1] = hn::IfThenElse(inner, zero, word);
    shares[2] = zero;
    return counts;
  }
  static HWY_INLINE V blend(std::size_t, V old, V share) { return hn::Add(old, share); }
};

void draw_chords_1(const ChordLookup& lookup, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ChordShare<1>{lookup}, frame, row);
}
void draw_chords_3(const ChordLookup& lookup, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ChordShare<3>{lookup}, frame, row);
}
void draw_short_chords(const ChordLookup& lookup, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ShortShare<ChordShare<1>>{{lookup}}, frame, row);
}
void draw_short_rectangle(const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ShortShare<RectangleShare>{}, frame, row);
}
void draw_short_sphere(const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ShortShare<SphereShare>{}, frame, row);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(draw_chords_1);
HWY_EXPORT(draw_chords_3);
HWY_EXPORT(draw_short_chords);
HWY_EXPORT(draw_short_rectangle);
HWY_EXPORT(draw_short_sphere);
}  // namespace

DrawRow chord_kernel(ChordLookup lookup, int channels) {
  if (channels == 1) {
    return [lookup = std::move(lookup)](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_chords_1)(lookup, frame, row);
    };
  }
  return [lookup = std::move(lookup)](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_chords_3)(lookup, frame, row);
  };
}

DrawRow short_chord_kernel(ChordLookup lookup) {
  return [lookup = std::move(lookup)](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_short_chords)(lookup, frame, row);
  };
}

DrawRow short_coverage_kernel(LightShape shape) {
  if (shape == LightShape::rectangle) {
    return [](const VolumeFrame& frame, VolumeRow& row) {
      HWY_DYNAMIC_DISPATCH(draw_short_rectangle)(frame, row);
    };
  }
  return [](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_short_sphere)(frame, row);
  };
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE
