// Draws a row of tiles: the tests and sums of the volumes for the lanes of a vector at once.
// Compiled once for every instruction set, as Highway has it; each lane does the same operations in
// the same order whatever the number of lanes, so that all give the same bits.
#if defined(WEDGESIM_FUNCTIONAL_RASTER_VOLUME_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_RASTER_VOLUME_SIMD_H
#undef WEDGESIM_FUNCTIONAL_RASTER_VOLUME_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_RASTER_VOLUME_SIMD_H
#endif

#include <algorithm>
#include <array>
#include <bit>
#include <cstring>

#include "functional/raster/lanes_simd.h"
#include "functional/raster/volume_raster.h"
#include "functional/raster/volume_rows.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

HWY_INLINE M mask_of(std::uint64_t bits) {
  std::array<std::uint8_t, 8> bytes;
  std::memcpy(bytes.data(), &bits, 8);
  return hn::LoadMaskBits(kTag, bytes.data());
}

HWY_INLINE std::uint64_t bits_of(M mask) {
  std::array<std::uint8_t, 8> bytes{};
  hn::StoreMaskBits(kTag, mask, bytes.data());
  std::uint64_t bits = 0;
  std::memcpy(&bits, bytes.data(), 8);
  return bits & ((std::uint64_t{1} << kLanes) - 1);
}

// One tile's pixels, as far as they are linear in the tile.
struct TileHere {
  double x, y;  // its middle, pixels
  const DepthTiles::Tile* tile;
  const float* depths;

  HWY_INLINE V dx(std::size_t first) const {
    return hn::Sub(column(first), set(0.5F * kTile - 0.5F));
  }
  HWY_INLINE V dy(std::size_t first) const {
    return hn::Sub(line(first), set(0.5F * kTile - 0.5F));
  }
  HWY_INLINE V dz(std::size_t first) const { return hn::LoadU(kTag, depths + first); }

 private:
  static HWY_INLINE V pixel(std::size_t first) { return hn::Iota(kTag, static_cast<float>(first)); }
  static HWY_INLINE V line(std::size_t first) {
    return hn::Floor(hn::Mul(pixel(first), set(1.0F / kTile)));
  }
  static HWY_INLINE V column(std::size_t first) {
    return hn::Sub(pixel(first), hn::Mul(line(first), set(kTile)));
  }
};

// A window form about the middle of a tile and its nearest depth.
struct TileForm {
  float middle, x, y, z;

  HWY_INLINE void place(const WindowForm& form, const TileHere& here) {
    middle =
        static_cast<float>(form.x * here.x + form.y * here.y + form.z * here.tile->z_min + form.w);
    x = static_cast<float>(form.x);
    y = static_cast<float>(form.y);
    z = static_cast<float>(form.z);
  }
  HWY_INLINE V value(V dx, V dy, V dz) const {
    const V flat = hn::Add(hn::Add(set(middle), hn::Mul(set(x), dx)), hn::Mul(set(y), dy));
    return hn::Add(flat, hn::Mul(set(z), dz));
  }
};

// The pixels on the shadow's side of a plane.
HWY_INLINE std::uint64_t inner_bits(const ScreenSide& side, int column, int row,
                                    const TileHere& here) {
  const FormRange range = form_range(side.plane, column, row, *here.tile);
  std::uint64_t bits = 0;
  if (range.low > range.doubt) {
    bits = ~std::uint64_t{0};
  } else if (range.high >= -range.doubt) {
    TileForm form;
    form.place(side.plane, here);
    for (std::size_t k = 0; k < kTilePixels; k += kLanes) {
      const V value = form.value(here.dx(k), here.dy(k), here.dz(k));
      bits |= bits_of(hn::Ge(value, hn::Zero(kTag))) << k;
    }
  }
  return side.minus ? ~bits : bits;
}

// Pixels with a depth below (or above) a limit.
HWY_INLINE std::uint64_t depth_bits(const TileHere& here, double limit, bool below) {
  std::uint64_t bits = 0;
  const V edge = set(static_cast<float>(limit - here.tile->z_min));
  for (std::size_t k = 0; k < kTilePixels; k += kLanes) {
    const V z = here.dz(k);
    bits |= bits_of(below ? hn::Lt(z, edge) : hn::Gt(z, edge)) << k;
  }
  return bits;
}

// The same at pixels that the polygon covers: by their depth where that decides.
HWY_INLINE std::uint64_t covered_inner_bits(const ScreenUmbra& umbra, std::uint64_t inner,
                                            const TileHere& here) {
  std::uint64_t before = 0;
  std::uint64_t beyond = 0;
  if (here.tile->z_min < umbra.z_min) before = depth_bits(here, umbra.z_min, true);
  if (here.tile->z_max > umbra.z_max) beyond = depth_bits(here, umbra.z_max, false);
  return umbra.eye_facing ? (inner & ~before) | beyond : (inner | before) & ~beyond;
}

// Where an umbra polygon counts, of the pixels it covers (Paper II, 3 and 5).
HWY_INLINE std::uint64_t umbra_hits(const ScreenUmbra& umbra, std::uint64_t inner) {
  if (umbra.role == traces::fb::UmbraRole_cap) return ~std::uint64_t{0};
  const std::uint64_t passes = umbra.eye_facing ? inner : ~inner;
  return umbra.z_fail ? ~passes : passes;
}

HWY_INLINE void add_to(float* words, std::uint64_t bits, float value) {
  for (std::size_t k = 0; k < kTilePixels; k += kLanes) {
    const V old = hn::LoadU(kTag, words + k);
    const V added = hn::IfThenElseZero(mask_of(bits >> k), set(value));
    hn::StoreU(hn::Add(old, added), kTag, words + k);
  }
}

// Pixels of a tile.
struct Visited {
  std::uint64_t read = 0, written = 0;
};

// A Share says what a wedge adds:
//   kForms, kChannels           window forms it wants, values it gives
//   operator()(forms, wedge, inner, shares, read) -> M
//                               shares[channel] at a vector of points; the lanes that count, and in
//                               `read` those whose depth is read: all, unless it says otherwise
// and, unless all its channels are sums, each a word, that umbra polygons change by 1:
//   kUmbraChannel               the only channel that they change
//   kWords                      the words that its channels are read and written as
//   blend(channel, old, share)  what a share makes of a value
template <typename Share>
constexpr bool kBlends = requires {
  Share::kWords;
};
template <typename Share>
constexpr std::size_t kWordsOf = [] {
  if constexpr (kBlends<Share>) return Share::kWords;
  return Share::kChannels;
}();

template <typename Share>
HWY_INLINE V blended(std::size_t channel, V old, V share) {
  if constexpr (kBlends<Share>) return Share::blend(channel, old, share);
  return hn::Add(old, share);
}

template <typename Share>
HWY_INLINE bool umbra_counts_in(std::size_t channel) {
  if constexpr (kBlends<Share>) return channel == Share::kUmbraChannel;
  return true;
}

// Adds a wedge's shares at the pixels of a tile.
// \param part  the pixels that may be changed
template <typename Share>
HWY_INLINE Visited add_wedge(const Share& share, const ScreenWedge& wedge, std::uint64_t inner,
                             std::uint64_t part, const TileHere& here, float* words,
                             std::size_t channel_stride) {
  TileForm placed[Share::kForms];
  for (std::size_t i = 0; i < Share::kForms; ++i) placed[i].place(wedge.forms[i], here);
  const std::uint64_t surface = here.tile->surface;
  Visited visited;
  for (std::size_t k = 0; k < kTilePixels; k += kLanes) {
    const V dx = here.dx(k);
    const V dy = here.dy(k);
    const V dz = here.dz(k);
    V forms[Share::kForms];
    for (std::size_t i = 0; i < Share::kForms; ++i) forms[i] = placed[i].value(dx, dy, dz);
    V shares[Share::kChannels];
    std::fill_n(shares, Share::kChannels, hn::Zero(kTag));
    M read = hn::Eq(dx, dx);
    const M counts = hn::And(share(forms, wedge, mask_of(inner >> k), shares, read),
                             mask_of((surface & part) >> k));
    visited.read |= bits_of(hn::And(read, mask_of(surface >> k))) << k;
    if (hn::AllFalse(kTag, counts)) continue;
    visited.written |= bits_of(counts) << k;
    for (std::size_t c = 0; c < Share::kChannels; ++c) {
      float* word = words + c * channel_stride + k;
      const V old = hn::LoadU(kTag, word);
      hn::StoreU(blended<Share>(c, old, hn::IfThenElseZero(counts, shares[c])), kTag, word);
    }
  }
  return visited;
}

HWY_INLINE std::uint64_t count_bits(std::uint64_t bits) {
  return static_cast<std::uint64_t>(std::popcount(bits));
}

// What is drawn of a side in a tile.
struct TileVisit {
  std::uint64_t covered = 0;  // pixels of the umbra polygon
  bool wedge = false;
  std::array<bool, 2> halves{};  // of a wedge in halves: outside and inside of the shadow
};

HWY_INLINE TileVisit visit(const VolumeFrame& frame, const ScreenSide& side, const SideRows& rows,
                           int column, int row, const DepthTiles::Tile& tile) {
  TileVisit visit;
  visit.wedge =
      rows.wedge_tiles.holds(column) && !(frame.cull && is_culled(side.wedge, column, row, tile));
  if (rows.umbra_tiles.holds(column)) visit.covered = covered_pixels(rows, column);
  for (std::size_t i = 0; i < 2 && visit.wedge && side.wedge.in_halves; ++i) {
    visit.halves[i] = rows.half_tiles[i].holds(column) &&
                      !(frame.cull && half_is_culled(side, i == 1, column, row, tile));
  }
  return visit;
}

// One side in one tile.
template <typename Share>
HWY_INLINE void draw_tile(const Share& share, const ScreenSide& side, const TileVisit& visit,
                          int column, const TileHere& here, std::size_t channel_stride,
                          VolumeRow& row) {
  const std::uint64_t covered = visit.covered;
  float* words = row.words.data() + kTilePixels * static_cast<std::size_t>(column);
  const bool cap = side.umbra.role == traces::fb::UmbraRole_cap;
  const std::uint64_t plain = cap ? 0 : inner_bits(side, column, row.row, here);
  std::uint64_t inner = plain;
  if (covered != 0) {
    const std::uint64_t by_depth = cap ? 0 : covered_inner_bits(side.umbra, plain, here);
    inner = (plain & ~covered) | (by_depth & covered);
    const std::uint64_t hits = umbra_hits(side.umbra, by_depth) & covered & here.tile->surface;
    if (!cap) row.accesses.z_reads += count_bits(covered & here.tile->surface);
    if (hits != 0) {
      const bool darker = side.umbra.eye_facing != side.umbra.z_fail;
      for (std::size_t c = 0; c < Share::kChannels; ++c) {
        if (!umbra_counts_in<Share>(c)) continue;
        add_to(words + c * channel_stride, hits, darker ? -1.0F : 1.0F);
      }
      row.accesses.light_reads += count_bits(hits) * kWordsOf<Share>;
      row.accesses.light_writes += count_bits(hits) * kWordsOf<Share>;
    }
  }
  if constexpr (Share::kForms > 0) {
    if (!visit.wedge) return;
    const auto add = [&](std::uint64_t part, std::uint64_t has_been_read) HWY_ATTR {
      const Visited visited =
          add_wedge(share, side.wedge, inner, part, here, words, channel_stride);
      row.accesses.z_reads += count_bits(visited.read & ~has_been_read);
      row.accesses.shares += count_bits(visited.written);
      row.accesses.light_reads += count_bits(visited.written) * kWordsOf<Share>;
      row.accesses.light_writes += count_bits(visited.written) * kWordsOf<Share>;
    };
    if (!side.wedge.in_halves) {
      add(~std::uint64_t{0}, covered);
      return;
    }
    const std::uint64_t not_by_plane = inner ^ plain;  // which half_is_culled does not know
    if (visit.halves[0] || (not_by_plane & ~inner) != 0) add(~inner, 0);
    if (visit.halves[1] || (not_by_plane & inner) != 0) add(inner, 0);
  }
}

// All sides of a frame in one row of tiles.
template <typename Share>
void draw_row_by(const Share& share, const VolumeFrame& frame, VolumeRow& row) {
  const DepthTiles& tiles = frame.tiles;
  const std::size_t channel_stride = static_cast<std::size_t>(tiles.columns()) * kTilePixels;
  const int y_begin = kTile * row.row;
  std::uint32_t group = 0;
  for (const ScreenSide& side : frame.sides) {
    if (frame.merge_groups && side.group != group) {
      merge_group(tiles, row);
      group = side.group;
    }
    if (side.y_begin >= y_begin + kTile || side.y_end <= y_begin) continue;
    const SideRows rows =
        side_rows(side, tiles.width(), tiles.height(), row.row, true, Share::kForms > 0);
    const SideRows::Span touched = joined(rows.umbra_tiles, rows.wedge_tiles);
    for (int column = touched.begin; column < touched.end; ++column) {
      const DepthTiles::Tile& tile = tiles.tile(column, row.row);
      if (tile.surface == 0) continue;
      const TileVisit here_drawn = visit(frame, side, rows, column, row.row, tile);
      if (here_drawn.covered == 0 && !here_drawn.wedge) continue;
      const TileHere here{kTile * column + 0.5 * kTile, y_begin + 0.5 * kTile, &tile,
                          tiles.depths(column, row.row)};
      if (frame.merge_groups) row.touched[static_cast<std::size_t>(column)] = 1;
      draw_tile(share, side, here_drawn, column, here, channel_stride, row);
    }
  }
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_RASTER_VOLUME_SIMD_H
