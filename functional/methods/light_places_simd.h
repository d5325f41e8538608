// Finds where pixels are in a window seen from a light. Compiled once for every instruction set, as
// Highway has it; all give the same bits.
#if defined(WEDGESIM_FUNCTIONAL_METHODS_LIGHT_PLACES_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_METHODS_LIGHT_PLACES_SIMD_H
#undef WEDGESIM_FUNCTIONAL_METHODS_LIGHT_PLACES_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_METHODS_LIGHT_PLACES_SIMD_H
#endif

#include <algorithm>
#include <array>
#include <cstring>

#include "functional/methods/light_places.h"
#include "functional/raster/depth_buffer.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

// Depths need double precision until they are places.
using Doubles = hn::CappedTag<double, 8>;
constexpr Doubles kDoubles;
constexpr hn::Rebind<float, Doubles> kHalves;

HWY_INLINE hn::Vec<Doubles> decode(traces::fb::DepthFormat format, const std::uint32_t* words) {
  const auto bits = hn::LoadU(hn::Rebind<std::uint32_t, Doubles>(), words);
  const auto number = [&]() HWY_ATTR {
    return hn::PromoteTo(kDoubles, hn::BitCast(hn::Rebind<std::int32_t, Doubles>(), bits));
  };
  const auto real = [&]() HWY_ATTR { return hn::PromoteTo(kDoubles, hn::BitCast(kHalves, bits)); };
  switch (format) {
    case traces::fb::DepthFormat_unorm24:
      return hn::Div(number(), hn::Set(kDoubles, 16777215.0));
    case traces::fb::DepthFormat_unorm16:
      return hn::Div(number(), hn::Set(kDoubles, 65535.0));
    case traces::fb::DepthFormat_float32:
      return real();
    case traces::fb::DepthFormat_float32_reversed:
      return hn::Sub(hn::Set(kDoubles, 1.0), real());
  }
  return hn::Zero(kDoubles);
}

// The pixels from x on in row y, at most LightPlaces::kPixels.
HWY_INLINE void place_pixels(const LightFromEye& from_eye, const DepthBuffer& depth, int x, int y,
                             int pixels, LightPlaces& places) {
  const std::size_t first = static_cast<std::size_t>(y) * static_cast<std::size_t>(depth.width) +
                            static_cast<std::size_t>(x);
  std::array<std::uint32_t, LightPlaces::kPixels> words{};
  std::memcpy(words.data(), &depth.words[first], 4 * static_cast<std::size_t>(pixels));
  const glm::dmat4& m = from_eye.place;
  const glm::dvec4 forms[4] = {{m[0].x, m[1].x, m[2].x, m[3].x},
                               {m[0].y, m[1].y, m[2].y, m[3].y},
                               {m[0].w, m[1].w, m[2].w, m[3].w},
                               from_eye.scale};
  constexpr int kStep = static_cast<int>(hn::MaxLanes(kDoubles));
  for (int i = 0; i < pixels; i += kStep) {
    const auto at = static_cast<std::size_t>(i);
    const auto z = decode(depth.format, &words[at]);
    const auto across = hn::Iota(kDoubles, static_cast<double>(i));
    const auto value = [&](const glm::dvec4& form) HWY_ATTR {
      const double begin = form.x * (x + 0.5) + form.y * (y + 0.5) + form.w;
      const auto flat =
          hn::Add(hn::Set(kDoubles, begin), hn::Mul(hn::Set(kDoubles, form.x), across));
      return hn::DemoteTo(kHalves, hn::Add(flat, hn::Mul(hn::Set(kDoubles, form.z), z)));
    };
    const auto w = value(forms[2]);
    const auto before = hn::Gt(w, hn::Zero(kHalves));
    const auto nowhere = hn::Set(kHalves, LightPlaces::kNowhere);
    hn::StoreU(hn::IfThenElse(before, hn::Div(value(forms[0]), w), nowhere), kHalves,
               &places.x[at]);
    hn::StoreU(hn::IfThenElse(before, hn::Div(value(forms[1]), w), nowhere), kHalves,
               &places.y[at]);
    hn::StoreU(hn::Div(value(forms[3]), w), kHalves, &places.inverse_depth[at]);
  }
  for (int i = 0; i < pixels; ++i) {
    if (depth.triangle[first + static_cast<std::size_t>(i)] != DepthBuffer::kSky) continue;
    places.x[static_cast<std::size_t>(i)] = LightPlaces::kNowhere;
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_METHODS_LIGHT_PLACES_SIMD_H
