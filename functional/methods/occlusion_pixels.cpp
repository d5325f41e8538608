// Compiled once for every instruction set (Highway); all give the same bits.
#include "functional/methods/occlusion_pixels.h"

#include <tbb/parallel_for.h>

#include <array>
#include <bit>
#include <cmath>

#ifndef WEDGESIM_FUNCTIONAL_METHODS_OCCLUSION_PIXELS_TYPES
#define WEDGESIM_FUNCTIONAL_METHODS_OCCLUSION_PIXELS_TYPES
namespace wedgesim::functional {
namespace {

// A pixel that tiles do not decide.
struct Undecided {
  int x = 0;
  Fragment fragment;
};

struct Row {
  int y = 0;
  float* values = nullptr;
  std::vector<Undecided> undecided;
  OcclusionLookup::Count count;
};

}  // namespace
}  // namespace wedgesim::functional
#endif

#undef HWY_TARGET_INCLUDE
#define HWY_TARGET_INCLUDE "functional/methods/occlusion_pixels.cpp"
#include "hwy/foreach_target.h"  // IWYU pragma: keep
// After it:
#include "functional/methods/light_places_simd.h"
#include "functional/raster/lanes_simd.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

using Whole = hn::RebindToSigned<D>;
using W = hn::Vec<Whole>;
constexpr Whole kWhole;

HWY_INLINE V load(const float* from) { return hn::LoadU(kTag, from); }

// The least and the greatest 1/z of the tiles that the texels of a lookup lie in.
struct Limits {
  V least, greatest;
};

class Tiles {
 public:
  explicit Tiles(const OcclusionLookup& lookup)
      : words_(&lookup.tiles()[0].least),
        size_(lookup.size()),
        interpolate_(lookup.options().interpolate) {}

  // Whether places are in the light's image.
  HWY_INLINE M shows(V x, V y) const {
    const V low = set(0.5F);
    const V high = set(static_cast<float>(size_) - 0.5F);
    return hn::And(hn::And(hn::Ge(x, low), hn::Ge(y, low)),
                   hn::And(hn::Lt(x, high), hn::Lt(y, high)));
  }

  // \param on  places that are in the image; elsewhere limits are anything
  HWY_INLINE Limits limits(V x, V y, M on, OcclusionLookup::Count& count) const {
    const V half = set(interpolate_ ? 0.5F : 0.0F);
    const V zero = hn::Zero(kTag);
    const W left = hn::ConvertTo(kWhole, hn::IfThenElse(on, hn::Sub(x, half), zero));
    const W top = hn::ConvertTo(kWhole, hn::IfThenElse(on, hn::Sub(y, half), zero));
    const W column = tile(left);
    const W row = tile(top);
    Limits all = at(column, row);
    count.map_reads += hn::CountTrue(kTag, on);
    if (!interpolate_) return all;
    // Four texels may lie in two tiles, or in four.
    const W right = tile(next(left));
    const W below = tile(next(top));
    const M across = hn::And(on, hn::RebindMask(kTag, hn::Ne(right, column)));
    const M down = hn::And(on, hn::RebindMask(kTag, hn::Ne(below, row)));
    if (hn::AllFalse(kTag, hn::Or(across, down))) return all;
    join(all, at(right, row));
    join(all, at(column, below));
    join(all, at(right, below));
    count.map_reads += hn::CountTrue(kTag, across) + hn::CountTrue(kTag, down) +
                       hn::CountTrue(kTag, hn::And(across, down));
    return all;
  }

 private:
  static HWY_INLINE W tile(W texel) {
    static_assert(kLightTile == 16);
    return hn::ShiftRight<4>(texel);
  }
  HWY_INLINE W next(W texel) const {
    return hn::Min(hn::Add(texel, hn::Set(kWhole, 1)), hn::Set(kWhole, size_ - 1));
  }
  HWY_INLINE Limits at(W column, W row) const {
    const W index = hn::Add(hn::Mul(row, hn::Set(kWhole, light_tiles(size_))), column);
    const W word = hn::Add(index, index);
    return {hn::GatherIndex(kTag, words_, word), hn::GatherIndex(kTag, words_ + 1, word)};
  }
  static HWY_INLINE void join(Limits& all, const Limits& other) {
    all.least = hn::Min(all.least, other.least);
    all.greatest = hn::Max(all.greatest, other.greatest);
  }

  const float* words_;
  int size_;
  bool interpolate_;
};

HWY_INLINE void note_undecided(const LightPlaces& places, std::size_t first, int x, M lanes,
                               const std::array<float, LightPlaces::kPixels>& facings, Row& row) {
  std::uint8_t bytes[8] = {};
  hn::StoreMaskBits(kTag, lanes, bytes);
  for (std::size_t lane = 0; lane < kLanes; ++lane) {
    if ((bytes[lane / 8] >> (lane % 8) & 1) == 0) continue;
    const std::size_t i = first + lane;
    row.undecided.push_back({x + static_cast<int>(i),
                             {glm::vec2(places.x[i], places.y[i]), places.inverse_depth[i],
                              static_cast<Facing>(static_cast<int>(facings[i]))}});
  }
}

void decide_by_tiles(const DepthBuffer& depth, const LightFromEye& from_eye,
                     const OcclusionLookup& lookup, std::span<const Facing> facing, Row& row) {
  const Tiles tiles(lookup);
  LightPlaces places;
  std::array<float, LightPlaces::kPixels> facings{};
  for (int x = 0; x < depth.width; x += LightPlaces::kPixels) {
    const int pixels = std::min(LightPlaces::kPixels, depth.width - x);
    const auto some = static_cast<std::size_t>(pixels);
    place_pixels(from_eye, depth, x, row.y, pixels, places);
    const std::uint32_t* triangles =
        &depth.triangle[static_cast<std::size_t>(row.y) * static_cast<std::size_t>(depth.width) +
                        static_cast<std::size_t>(x)];
    for (std::size_t i = 0; i < some; ++i) {
      const Facing f = triangles[i] == DepthBuffer::kSky ? Facing::light : facing[triangles[i]];
      facings[i] = static_cast<float>(static_cast<int>(f));
    }
    for (std::size_t i = 0; i < some; i += kLanes) {
      const V px = load(&places.x[i]);
      const V py = load(&places.y[i]);
      const V way = load(&facings[i]);
      const M valid = hn::FirstN(kTag, some - i);
      const M placed = hn::And(valid, hn::Gt(px, set(LightPlaces::kNowhere)));
      const M away = hn::And(placed, hn::Eq(way, set(static_cast<float>(Facing::away))));
      const M on = hn::And(hn::AndNot(away, placed), tiles.shows(px, py));
      M dark = away;
      if (!hn::AllFalse(kTag, on)) {
        const Limits limits = tiles.limits(px, py, on, row.count);
        const V nearer = hn::Div(load(&places.inverse_depth[i]), set(OcclusionLookup::kOwnDepth));
        const M hidden = hn::And(on, hn::Gt(limits.least, nearer));
        const M clear = hn::And(on, hn::Le(limits.greatest, nearer));
        const M turned = hn::Gt(way, hn::Zero(kTag));
        dark = hn::Or(dark, hn::Or(hidden, hn::And(clear, turned)));
        const M undecided = hn::AndNot(hn::Or(hidden, clear), on);
        if (!hn::AllFalse(kTag, undecided)) note_undecided(places, i, x, undecided, facings, row);
      }
      hn::BlendedStore(hn::Zero(kTag), dark, kTag, row.values + x + i);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#if HWY_ONCE
namespace wedgesim::functional {

namespace {
HWY_EXPORT(decide_by_tiles);
}  // namespace

OcclusionLookup::Count light_pixels(const MethodInput& input, const Window& light_window,
                                    const OcclusionLookup& lookup, std::span<const Facing> facing,
                                    std::vector<float>& values) {
  const LightFromEye from_eye(light_window, input.window);
  const auto width = static_cast<std::size_t>(input.window.width);
  std::vector<OcclusionLookup::Count> counts(static_cast<std::size_t>(input.window.height));
  tbb::parallel_for(std::size_t{0}, counts.size(), [&](std::size_t y) {
    Row row{static_cast<int>(y), values.data() + y * width, {}, {}};
    HWY_DYNAMIC_DISPATCH(decide_by_tiles)(input.depth, from_eye, lookup, facing, row);
    for (const Undecided& pixel : row.undecided) {
      row.values[pixel.x] = lookup.visible(pixel.fragment, row.count);
    }
    counts[y] = row.count;
  });
  OcclusionLookup::Count all;
  for (const auto& count : counts) {
    all.depth_reads += count.depth_reads;
    all.map_reads += count.map_reads;
  }
  return all;
}

}  // namespace wedgesim::functional
#endif  // HWY_ONCE
