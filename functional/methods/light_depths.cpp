// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/light_depths.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/light_depths.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/raster/map_blocks_simd.h"
#include "hwy/highway.h"

#ifndef WEDGESIM_FUNCTIONAL_METHODS_LIGHT_DEPTHS_TAG
#define WEDGESIM_FUNCTIONAL_METHODS_LIGHT_DEPTHS_TAG
namespace wedgesim::functional {
// Tags of triangles: of casters, facing the light or away from it, and of what casts nothing.
constexpr std::uint8_t kFront = 0;
constexpr std::uint8_t kBack = 1;
constexpr std::uint8_t kReceiver = 2;
}  // namespace wedgesim::functional
#endif

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

constexpr float kInside = 0.25F;      // of the way from a caster's back to its front
constexpr double kMostSlope = 0.002;  // of the depth, over a texel: steeper is seen from aside
constexpr int kBlocks = kLightTile / kBlockEdge;

// A row of tiles as it is drawn, block by block: casters' nearest fronts, 0 where none is, the
// maps' nearest backs of them, and the farthest of what casts nothing, by −1/z so that again the
// greatest is kept, in the place of the map's surfaces.
class TileRow {
 public:
  TileRow(ShadowMaps& maps, int row)
      : columns_(maps.casters.block_columns()),
        rows_(std::min(kBlocks, columns_ - row * kBlocks)),
        fronts_(static_cast<std::size_t>(rows_ * columns_ * kBlock), 0.0F),
        backs_(maps.casters.block(0, row * kBlocks)),
        receivers_(maps.surfaces.block(0, row * kBlocks)) {
    std::fill_n(backs_, fronts_.size(), 0.0F);
    std::fill_n(receivers_, fronts_.size(), -HUGE_VALF);
  }

  // Of a band, whose first row is y, whatever a triangle covers. Returns texels covered.
  HWY_INLINE std::uint64_t draw(const MapTriangle& triangle, int size, int y) {
    const TexelPlane& plane = triangle.inverse_w;
    const bool back = triangle.tag == kBack;
    // A back is as far as it is anywhere within a texel: a caster may be thinner than that.
    const double moved =
        back ? std::min(std::abs(plane.a) + std::abs(plane.b), kMostSlope * triangle.inverse_low)
             : 0.0;
    const V away = set(static_cast<float>(moved));
    const bool receiver = triangle.tag == kReceiver;
    const V sign = set(receiver ? -1.0F : 1.0F);
    float* drawn = receiver ? receivers_ : back ? backs_ : fronts_.data();
    return for_each_block(triangle, size, y, [&](int column, int row, const auto& part) HWY_ATTR {
      const int x = column * kBlockEdge;
      const int row_of_map = y / kBlockEdge + row;
      float* texels = drawn + first_of(column, row_of_map % kBlocks);
      const BlockPlane in_block(plane, x, row_of_map * kBlockEdge);
      for (int lane = 0; lane < kBlock; lane += kLanes) {
        const V depth = hn::Mul(sign, hn::Sub(inverse_w(triangle, in_block, lane), away));
        const V kept = hn::LoadU(kTag, texels + lane);
        const V greatest = hn::IfThenElse(part.covered(x, lane), hn::Max(kept, depth), kept);
        hn::StoreU(greatest, kTag, texels + lane);
      }
    });
  }

  // From the back of the first layer of casters to a place inside it; and what a tile then holds.
  HWY_INLINE TileDepths finish(int tile_column) {
    V least = set(HUGE_VALF);
    V greatest = hn::Zero(kTag);
    const int end = std::min(columns_, (tile_column + 1) * kBlocks);
    for (int row = 0; row < rows_; ++row) {
      for (int column = tile_column * kBlocks; column < end; ++column) {
        for (std::size_t lane = 0; lane < kBlock; lane += kLanes) {
          const V caster = finish_lanes(first_of(column, row) + lane);
          least = hn::Min(least, caster);
          greatest = hn::Max(greatest, caster);
        }
      }
    }
    return {hn::GetLane(hn::MinOfLanes(kTag, least)), hn::GetLane(hn::MaxOfLanes(kTag, greatest))};
  }

 private:
  std::size_t first_of(int column, int row) const {
    return static_cast<std::size_t>(row * columns_ + column) * kBlock;
  }
  HWY_INLINE V finish_lanes(std::size_t at) {
    const V zero = hn::Zero(kTag);
    const V front = hn::LoadU(kTag, &fronts_[at]);
    const V back = hn::LoadU(kTag, backs_ + at);
    const V in_front = hn::Max(zero, hn::Sub(front, back));
    const V inside = hn::Add(back, hn::Mul(set(kInside), in_front));
    const V caster = hn::IfThenElseZero(hn::Gt(back, zero), inside);
    hn::StoreU(caster, kTag, backs_ + at);
    const V receiver = hn::LoadU(kTag, receivers_ + at);
    const M receives = hn::Gt(receiver, set(-HUGE_VALF));
    hn::StoreU(hn::Max(front, hn::IfThenElseZero(receives, hn::Neg(receiver))), kTag,
               receivers_ + at);
    return caster;
  }

  int columns_, rows_;  // of blocks
  std::vector<float> fronts_;
  float* backs_;
  float* receivers_;
};

std::uint64_t draw_tiles(const MapTriangles& triangles, int tile_row, ShadowMaps& maps) {
  constexpr int kBands = kLightTile / MapTriangles::kBandRows;
  const int size = maps.casters.size();
  TileRow row(maps, tile_row);
  std::uint64_t compared = 0;
  const int bands = MapTriangles::bands(size);
  for (int band = tile_row * kBands; band < std::min(bands, (tile_row + 1) * kBands); ++band) {
    for_each_triangle(triangles.band(band), [&](const MapTriangle& triangle) HWY_ATTR {
      compared += row.draw(triangle, size, band * MapTriangles::kBandRows);
    });
  }
  const int tiles = light_tiles(size);
  for (int column = 0; column < tiles; ++column) {
    maps.caster_tiles[static_cast<std::size_t>(tile_row * tiles + column)] = row.finish(column);
  }
  return compared;
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {
namespace {

HWY_EXPORT(draw_tiles);

// Of each object its first triangle, then the number of all.
std::vector<std::size_t> first_triangles(const Scene& scene) {
  std::vector<std::size_t> first{0};
  for (const Object& object : scene.objects) {
    first.push_back(first.back() + object.mesh.triangles.size());
  }
  return first;
}

}  // namespace

ShadowMaps draw_shadow_maps(const Scene& scene, std::span<const Silhouette> silhouettes,
                            const Window& light_window) {
  const std::vector<std::size_t> first = first_triangles(scene);
  const MapTriangles triangles(light_window, first.back(), [&](std::size_t t) {
    const auto next = std::upper_bound(first.begin(), first.end(), t);
    const auto i = static_cast<std::size_t>(next - first.begin()) - 1;
    const Object& object = scene.objects[i];
    const Mesh& mesh = object.mesh;
    const auto& c = mesh.triangles[t - first[i]];
    MapTriangles::Input input{{mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]}};
    input.tag = !object.casts                               ? kReceiver
                : silhouettes[i].light_facing[t - first[i]] ? kFront
                                                            : kBack;
    return input;
  });

  const int size = light_window.width;
  const auto tiles = static_cast<std::size_t>(light_tiles(size));
  ShadowMaps maps{LightDepths(size), LightDepths(size), std::vector<TileDepths>(tiles * tiles)};
  std::vector<std::uint64_t> compared(tiles, 0);
  tbb::parallel_for(std::size_t{0}, tiles, [&](std::size_t row) {
    compared[row] = HWY_DYNAMIC_DISPATCH(draw_tiles)(triangles, static_cast<int>(row), maps);
  });
  for (const std::uint64_t of_tiles : compared) maps.compared += of_tiles;
  return maps;
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE
