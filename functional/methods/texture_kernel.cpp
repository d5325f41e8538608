// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/texture_kernel.h"

#include <utility>

#include "functional/light/split_word.h"

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/texture_kernel.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/light/coverage_simd.h"
#include "functional/light/emission_simd.h"
#include "functional/light/texture_simd.h"
#include "functional/raster/volume_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

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
    shares[0] = hn::IfThenElseZero(inner, word);
    shares[1] = hn::IfThenZeroElse(inner, word);
    shares[2] = zero;
    return counts;
  }
  static HWY_INLINE V blend(std::size_t, V old, V share) { return hn::Add(old, share); }
};

template <std::size_t channels>
using Nearest = ChordShare<TextureLookup<channels, TextureFilter::nearest>>;
template <std::size_t channels>
using Quadlinear = ChordShare<TextureLookup<channels, TextureFilter::quadlinear>>;

void draw_nearest_1(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(Nearest<1>{{table}}, frame, row);
}
void draw_nearest_3(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(Nearest<3>{{table}}, frame, row);
}
void draw_quadlinear_1(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(Quadlinear<1>{{table}}, frame, row);
}
void draw_quadlinear_3(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(Quadlinear<3>{{table}}, frame, row);
}
void draw_short_nearest(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ShortShare<Nearest<1>>{{{table}}}, frame, row);
}
void draw_short_quadlinear(const CoverageTexture& table, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ShortShare<Quadlinear<1>>{{{table}}}, frame, row);
}
void draw_emission(const Emission& emission, const VolumeFrame& frame, VolumeRow& row) {
  draw_row_by(ChordShare<EmissionLookup>{{emission}}, frame, row);
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
#include "base/check.h"

namespace wedgesim::functional {

namespace {
HWY_EXPORT(draw_nearest_1);
HWY_EXPORT(draw_nearest_3);
HWY_EXPORT(draw_quadlinear_1);
HWY_EXPORT(draw_quadlinear_3);
HWY_EXPORT(draw_short_nearest);
HWY_EXPORT(draw_short_quadlinear);
HWY_EXPORT(draw_emission);
HWY_EXPORT(draw_short_rectangle);
HWY_EXPORT(draw_short_sphere);
}  // namespace

DrawRow texture_kernel(std::shared_ptr<const CoverageTexture> table, TextureFilter filter) {
  const bool nearest = filter == TextureFilter::nearest;
  const bool colours = table->channels() == 3;
  return [table = std::move(table), nearest, colours](const VolumeFrame& frame, VolumeRow& row) {
    if (nearest && colours) {
      HWY_DYNAMIC_DISPATCH(draw_nearest_3)(*table, frame, row);
    } else if (nearest) {
      HWY_DYNAMIC_DISPATCH(draw_nearest_1)(*table, frame, row);
    } else if (colours) {
      HWY_DYNAMIC_DISPATCH(draw_quadlinear_3)(*table, frame, row);
    } else {
      HWY_DYNAMIC_DISPATCH(draw_quadlinear_1)(*table, frame, row);
    }
  };
}

DrawRow emission_kernel(Emission emission) {
  CHECK_EQ(emission.channels(), 3);
  return [emission = std::move(emission)](const VolumeFrame& frame, VolumeRow& row) {
    HWY_DYNAMIC_DISPATCH(draw_emission)(emission, frame, row);
  };
}

DrawRow short_texture_kernel(std::shared_ptr<const CoverageTexture> table, TextureFilter filter) {
  CHECK_EQ(table->channels(), 1);
  const bool nearest = filter == TextureFilter::nearest;
  return [table = std::move(table), nearest](const VolumeFrame& frame, VolumeRow& row) {
    if (nearest) {
      HWY_DYNAMIC_DISPATCH(draw_short_nearest)(*table, frame, row);
    } else {
      HWY_DYNAMIC_DISPATCH(draw_short_quadlinear)(*table, frame, row);
    }
  };
}

DrawRow short_coverage_kernel(LightShape shape) {
  const bool rectangle = shape == LightShape::rectangle;
  return [rectangle](const VolumeFrame& frame, VolumeRow& row) {
    if (rectangle) {
      HWY_DYNAMIC_DISPATCH(draw_short_rectangle)(frame, row);
    } else {
      HWY_DYNAMIC_DISPATCH(draw_short_sphere)(frame, row);
    }
  };
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE
