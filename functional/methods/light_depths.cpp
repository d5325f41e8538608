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
// The tag of a triangle of a caster that faces away from the light; all others have 0.
constexpr std::uint8_t kBack = 1;
}  // namespace wedgesim::functional
#endif

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

constexpr float kFront = 0.25F;       // of the way from a caster's back to its front
constexpr double kMostSlope = 0.002;  // of the depth, over a texel: steeper is seen from aside

// Whatever of a band a triangle covers is drawn: of casters' backs one map, of all else the other.
HWY_INLINE std::uint64_t draw(const MapTriangle& triangle, int y, ShadowMaps& maps) {
  const TexelPlane& plane = triangle.inverse_w;
  const bool back = triangle.tag == kBack;
  // A back is as far as it is anywhere within a texel: a caster may be thinner than that.
  const double moved =
      back ? std::min(std::abs(plane.a) + std::abs(plane.b), kMostSlope * triangle.inverse_low)
           : 0.0;
  const V away = set(static_cast<float>(moved));
  LightDepths& map = back ? maps.casters : maps.surfaces;
  return for_each_block(
      triangle, map.size(), y, [&](int column, int row, const BlockRows& rows) HWY_ATTR {
        const int x = column * kBlockEdge;
        const int row_of_map = y / kBlockEdge + row;
        float* texels = map.block(column, row_of_map);
        const BlockPlane in_block(plane, x, row_of_map * kBlockEdge);
        for (int lane = 0; lane < kBlock; lane += kLanes) {
          const V depth = hn::Sub(inverse_w(triangle, in_block, lane), away);
          const V kept = hn::LoadU(kTag, texels + lane);
          const V nearest = hn::IfThenElse(rows.covered(x, lane), hn::Max(kept, depth), kept);
          hn::StoreU(nearest, kTag, texels + lane);
        }
      });
}

// From the back of the first layer of casters to a place inside it; and what a tile then holds.
HWY_INLINE TileDepths finish_tile(ShadowMaps& maps, int tile_column, int tile_row) {
  constexpr int kBlocks = kLightTile / kBlockEdge;
  const int columns = maps.casters.block_columns();
  V least = set(HUGE_VALF);
  V greatest = hn::Zero(kTag);
  for (int row = tile_row * kBlocks; row < std::min(columns, (tile_row + 1) * kBlocks); ++row) {
    for (int column = tile_column * kBlocks;
         column < std::min(columns, (tile_column + 1) * kBlocks); ++column) {
      const float* surfaces = maps.surfaces.block(column, row);
      float* backs = maps.casters.block(column, row);
      for (int lane = 0; lane < kBlock; lane += kLanes) {
        const V zero = hn::Zero(kTag);
        const V back = hn::LoadU(kTag, backs + lane);
        const V in_front = hn::Max(zero, hn::Sub(hn::LoadU(kTag, surfaces + lane), back));
        const V inside = hn::Add(back, hn::Mul(set(kFront), in_front));
        const V caster = hn::IfThenElseZero(hn::Gt(back, zero), inside);
        hn::StoreU(caster, kTag, backs + lane);
        least = hn::Min(least, caster);
        greatest = hn::Max(greatest, caster);
      }
    }
  }
  return {hn::GetLane(hn::MinOfLanes(kTag, least)), hn::GetLane(hn::MaxOfLanes(kTag, greatest))};
}

// A row of tiles.
std::uint64_t draw_tiles(const MapTriangles& triangles, int tile_row, ShadowMaps& maps) {
  constexpr int kBands = kLightTile / MapTriangles::kBandRows;
  constexpr int kBlocks = kLightTile / kBlockEdge;
  const int columns = maps.casters.block_columns();
  for (int row = tile_row * kBlocks; row < std::min(columns, (tile_row + 1) * kBlocks); ++row) {
    const std::size_t texels = static_cast<std::size_t>(columns) * kBlock;
    std::fill_n(maps.surfaces.block(0, row), texels, 0.0F);
    std::fill_n(maps.casters.block(0, row), texels, 0.0F);
  }
  std::uint64_t compared = 0;
  const int bands = MapTriangles::bands(maps.casters.size());
  for (int band = tile_row * kBands; band < std::min(bands, (tile_row + 1) * kBands); ++band) {
    for_each_triangle(triangles.band(band), [&](const MapTriangle& triangle) HWY_ATTR {
      compared += draw(triangle, band * MapTriangles::kBandRows, maps);
    });
  }
  const int tiles = light_tiles(maps.casters.size());
  for (int column = 0; column < tiles; ++column) {
    maps.caster_tiles[static_cast<std::size_t>(tile_row * tiles + column)] =
        finish_tile(maps, column, tile_row);
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
    const bool back = object.casts && !silhouettes[i].light_facing[t - first[i]];
    input.tag = back ? kBack : 0;
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
