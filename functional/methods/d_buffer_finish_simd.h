// Turns a band of a D-buffer into texels of the map. Compiled once for every instruction set, as
// Highway has it; all give the same bits.
#if defined(WEDGESIM_FUNCTIONAL_METHODS_D_BUFFER_FINISH_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_METHODS_D_BUFFER_FINISH_SIMD_H
#undef WEDGESIM_FUNCTIONAL_METHODS_D_BUFFER_FINISH_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_METHODS_D_BUFFER_FINISH_SIMD_H
#endif

#include <algorithm>
#include <cstring>

#include "functional/methods/d_buffer_band.h"
#include "functional/raster/map_blocks_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

using Plane = DBufferBand::Plane;

HWY_INLINE float* word(float* texels, Plane plane) { return texels + DBufferBand::word(plane); }
HWY_INLINE V value(float* texels, Plane plane) { return load(word(texels, plane)); }

HWY_INLINE V inverse_lengths(const MapRays& rays, int x, int y, int lane) {
  V square = hn::Zero(kTag);
  for (int axis = 0; axis < 3; ++axis) {
    const BlockPlane along({rays.dx()[axis], rays.dy()[axis], rays.at(0.0, 0.0)[axis]}, x, y);
    square = hn::Add(square, hn::Mul(along.at(lane), along.at(lane)));
  }
  return hn::Div(set(1.0F), hn::Sqrt(square));
}
HWY_INLINE void finish_lanes(float* words, V scale, float* texels, float* edges) {
  const auto scaled = [&](Plane plane) HWY_ATTR { return hn::Mul(scale, value(words, plane)); };
  const V umbra = value(words, Plane::umbra);
  hn::StoreInterleaved4(scaled(Plane::occluder),
                        hn::IfThenElse(hn::Lt(umbra, hn::Zero(kTag)), umbra, scaled(Plane::umbra)),
                        scaled(Plane::penumbra), scaled(Plane::umbra_edge), kTag, texels);
  store(scaled(Plane::penumbra_edge), edges);
}
// Puts a block into the map.
HWY_INLINE void put(const float* texels, const float* edges, int x, int y, DBuffer& map) {
  const auto some = static_cast<std::size_t>(std::min(kBlockEdge, map.width - x));
  for (int line = 0; line < std::min(kBlockEdge, map.width - y); ++line) {
    const std::size_t at =
        static_cast<std::size_t>(y + line) * static_cast<std::size_t>(map.width) +
        static_cast<std::size_t>(x);
    std::memcpy(&map.texels[at], texels + 4 * kBlockEdge * line, some * sizeof(DBuffer::Texel));
    if (!map.penumbra_edge) continue;
    std::memcpy(&map.penumbra_edge[at], edges + kBlockEdge * line, some * sizeof(float));
  }
}

// Turns the keys of a band into inverse distances; interpolated keys are that already.
// \param y_begin  of its first row
HWY_INLINE void finish_band(DBufferBand& rows, int y_begin, bool interpolated, DBuffer& map) {
  const MapRays rays(map.view);
  const int y_end = std::min(map.width, y_begin + DBufferBand::kRows);
  for (int y = y_begin; y < y_end; y += kBlockEdge) {
    for (int x = 0; x < map.width; x += kBlockEdge) {
      float* words = rows.block(x / kBlockEdge, (y - y_begin) / kBlockEdge);
      HWY_ALIGN float texels[4 * kBlock];
      HWY_ALIGN float edges[kBlock];
      for (int lane = 0; lane < kBlock; lane += kLanes) {
        const V scale = interpolated ? set(1.0F) : inverse_lengths(rays, x, y, lane);
        finish_lanes(words + lane, scale, texels + 4 * lane, edges + lane);
      }
      put(texels, edges, x, y, map);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_METHODS_D_BUFFER_FINISH_SIMD_H
