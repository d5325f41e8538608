// The vectors that pixels are computed in: up to 16 of them at once. Compiled once for every
// instruction set, as Highway has it.
#if defined(WEDGESIM_FUNCTIONAL_RASTER_LANES_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_RASTER_LANES_SIMD_H
#undef WEDGESIM_FUNCTIONAL_RASTER_LANES_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_RASTER_LANES_SIMD_H
#endif

#include <cstddef>

#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, 16>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D kTag;
constexpr std::size_t kLanes = hn::MaxLanes(kTag);

HWY_INLINE V set(float value) { return hn::Set(kTag, value); }

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_RASTER_LANES_SIMD_H
