// Draws triangles into a band of a map (light_map.h) by blocks of texels, so that slivers fill
// vectors too. Compiled once for every instruction set, as Highway has it; all give the same bits.
#if defined(WEDGESIM_FUNCTIONAL_RASTER_MAP_BLOCKS_SIMD_H) == defined(HWY_TARGET_TOGGLE)
#ifdef WEDGESIM_FUNCTIONAL_RASTER_MAP_BLOCKS_SIMD_H
#undef WEDGESIM_FUNCTIONAL_RASTER_MAP_BLOCKS_SIMD_H
#else
#define WEDGESIM_FUNCTIONAL_RASTER_MAP_BLOCKS_SIMD_H
#endif

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstdlib>
#include <span>
#include <utility>

#include "functional/raster/light_map.h"
#include "hwy/cache_control.h"
#include "hwy/highway.h"

HWY_BEFORE_NAMESPACE();
namespace wedgesim::functional {
namespace HWY_NAMESPACE {
namespace {

namespace hn = hwy::HWY_NAMESPACE;

using D = hn::CappedTag<float, kBlock>;
using V = hn::Vec<D>;
using M = hn::Mask<D>;
constexpr D kTag;
constexpr int kLanes = static_cast<int>(hn::MaxLanes(kTag));

HWY_INLINE V set(float value) { return hn::Set(kTag, value); }
HWY_INLINE V load(const float* from) { return hn::Load(kTag, from); }
HWY_INLINE void store(V value, float* to) { hn::Store(value, kTag, to); }

// By the rule of spans.h: of each row of a band the texels begin ≤ x < end that a triangle covers;
// of one that it does not cover the map's width and 0.
struct TriangleRows {
  static constexpr int kRows = MapTriangles::kBandRows;
  HWY_ALIGN float begin[kRows];
  HWY_ALIGN float end[kRows];

  // To add to a place that is to count, and to one that is not: beyond all there can be.
  static constexpr double kBeyond[2] = {0.0, 0x1p60};

  // \param y  of the band's first row
  HWY_INLINE void cover(const MapTriangle& triangle, int size, int y) {
    using Doubles = hn::CappedTag<double, kRows>;
    constexpr Doubles tag;
    const hn::Rebind<float, Doubles> halves;
    const auto all = [](double value) HWY_ATTR { return hn::Set(tag, value); };
    constexpr int kStep = static_cast<int>(hn::MaxLanes(tag));
    const auto& [a, b, c] = triangle.corners;
    const std::int32_t low = std::min({a.y, b.y, c.y});
    std::int32_t high = std::min(std::max({a.y, b.y, c.y}), 256 * (size - 1) + 128);
    for (std::size_t i = 0; i < 3; ++i) {  // centres on a bottom edge are outside
      const auto& p = triangle.corners[i];
      const auto& q = triangle.corners[(i + 1) % 3];
      const bool bottom = p.y == q.y && (triangle.faces_light ? p.x < q.x : p.x > q.x);
      if (bottom) high = std::min(high, p.y - 1);
    }
    for (int row = 0; row < kRows; row += kStep) {
      const auto centre =
          hn::Add(all(256.0 * (y + row) + 128.0), hn::Mul(all(256.0), hn::Iota(tag, 0.0)));
      auto first = hn::Zero(tag);
      auto past = all(size);
      for (std::size_t i = 0; i < 3; ++i) {
        const MapTriangle::Corner* p = &triangle.corners[i];
        const MapTriangle::Corner* q = &triangle.corners[(i + 1) % 3];
        if (triangle.faces_light) std::swap(p, q);
        // No branch on which side it is: it is unpredictable.
        const bool level = p->y == q->y;
        const bool left = q->y < p->y;
        // The side crosses a centre's line, rounded up, at p.x − ⌊along / down⌋: whole numbers
        // below 2⁵³, so the division is exact once its remainder is.
        const double down = std::max(1, std::abs(q->y - p->y));
        const double across = left ? q->x - p->x : p->x - q->x;
        const auto along = hn::Mul(all(across), hn::Sub(centre, all(p->y)));
        auto quotient = hn::Floor(hn::Div(along, all(down)));
        const auto rest = hn::Sub(along, hn::Mul(quotient, all(down)));
        const auto one = all(1.0);
        quotient = hn::Sub(quotient, hn::IfThenElseZero(hn::Lt(rest, hn::Zero(tag)), one));
        quotient = hn::Add(quotient, hn::IfThenElseZero(hn::Ge(rest, all(down)), one));
        // The first centre 256·x + 128 that is not left of it.
        const auto x = hn::Floor(hn::Mul(hn::Sub(all(p->x + 127.0), quotient), all(1.0 / 256.0)));
        first = hn::Max(first, hn::Sub(x, all(kBeyond[level || !left])));
        past = hn::Min(past, hn::Add(x, all(kBeyond[level || left])));
      }
      const auto meets = hn::And(hn::Ge(centre, all(low)), hn::Le(centre, all(high)));
      const auto some = hn::And(meets, hn::Lt(first, past));
      hn::Store(hn::DemoteTo(halves, hn::IfThenElse(some, first, all(size))), halves, begin + row);
      hn::Store(hn::DemoteTo(halves, hn::IfThenElseZero(some, past)), halves, end + row);
    }
  }
};

// Texels of a block by the lanes of vectors, row by row.
HWY_ALIGN constexpr float kColumns[] = {0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3, 0, 1, 2, 3};
HWY_ALIGN constexpr float kLines[] = {0, 0, 0, 0, 1, 1, 1, 1, 2, 2, 2, 2, 3, 3, 3, 3};

// A plane in a block: its value at the first texel in double precision, so that single precision
// has the digits of what it grows by.
struct BlockPlane {
  float first, dx, dy;
  HWY_INLINE BlockPlane(const TexelPlane& plane, int x, int y)
      : first(static_cast<float>(plane.at(x + 0.5, y + 0.5))),
        dx(static_cast<float>(plane.a)),
        dy(static_cast<float>(plane.b)) {}
  HWY_INLINE V at(int lane) const {
    const V along_row = hn::Add(set(first), hn::Mul(set(dx), load(kColumns + lane)));
    return hn::Add(along_row, hn::Mul(set(dy), load(kLines + lane)));
  }
};

// What a triangle covers of one row of blocks: the ends of each texel's row.
struct BlockRows {
  HWY_ALIGN float begin[kBlock];
  HWY_ALIGN float end[kBlock];
  float x_begin, x_end;  // of all
  float texels = 0.0F;

  // \param row  of the first of its rows
  HWY_INLINE BlockRows(const TriangleRows& rows, int row) {
    x_begin = rows.begin[row];
    x_end = rows.end[row];
    for (int line = 0; line < kBlockEdge; ++line) {
      const float from = rows.begin[row + line];
      const float to = rows.end[row + line];
      std::fill_n(begin + line * kBlockEdge, kBlockEdge, from);
      std::fill_n(end + line * kBlockEdge, kBlockEdge, to);
      x_begin = std::min(x_begin, from);
      x_end = std::max(x_end, to);
      texels += std::max(0.0F, to - from);
    }
  }
  // The texels of a block from x on that are covered.
  HWY_INLINE M covered(int x, int lane) const {
    const V column = hn::Add(set(static_cast<float>(x)), load(kColumns + lane));
    return hn::And(hn::Ge(column, load(begin + lane)), hn::Lt(column, load(end + lane)));
  }
};

// What a small triangle covers of blocks: by the integer functions of its sides, which there have
// room in 32 bits.
class BlockSides {
 public:
  static constexpr std::int32_t kMostExtent = 16 * 256;

  HWY_INLINE explicit BlockSides(const MapTriangle& triangle) : corners_(triangle.corners) {
    if (triangle.faces_light) std::swap(corners_[1], corners_[2]);
    for (std::size_t i = 0; i < 3; ++i) {
      dx_[i] = corners_[(i + 1) % 3].x - corners_[i].x;
      dy_[i] = corners_[(i + 1) % 3].y - corners_[i].y;
      // On a left or a top side centres are inside.
      least_[i] = dy_[i] < 0 || (dy_[i] == 0 && dx_[i] > 0) ? 0 : 1;
    }
  }
  HWY_INLINE void place(int column, int row) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::int32_t x = 256 * kBlockEdge * column + 128 - corners_[i].x;
      const std::int32_t y = 256 * kBlockEdge * row + 128 - corners_[i].y;
      first_[i] = dx_[i] * y - dy_[i] * x - least_[i];
    }
  }
  // The texels of the block that it was placed at that are covered.
  HWY_INLINE M covered(int /*x*/, int lane) const {
    const hn::RebindToSigned<D> whole;
    const auto column = hn::ConvertTo(whole, load(kColumns + lane));
    const auto line = hn::ConvertTo(whole, load(kLines + lane));
    auto all = hn::Zero(whole);
    for (std::size_t i = 0; i < 3; ++i) {
      const auto down = hn::Mul(hn::Set(whole, 256 * dx_[i]), line);
      const auto across = hn::Mul(hn::Set(whole, 256 * dy_[i]), column);
      all = hn::Or(all, hn::Add(hn::Set(whole, first_[i]), hn::Sub(down, across)));
    }
    return hn::RebindMask(kTag, hn::Gt(all, hn::Set(whole, -1)));
  }

 private:
  std::array<MapTriangle::Corner, 3> corners_;
  std::array<std::int32_t, 3> dx_, dy_, least_, first_{};
};

// Calls draw(triangle) for each, and asks memory early for those that follow.
template <typename Draw>
HWY_INLINE void for_each_triangle(std::span<const MapTriangle* const> triangles, Draw&& draw) {
  constexpr std::size_t kAhead = 8;
  constexpr std::size_t kLineBytes = 64;
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    if (i + kAhead < triangles.size()) {
      const auto* next = reinterpret_cast<const char*>(triangles[i + kAhead]);
      hwy::Prefetch(next);
      hwy::Prefetch(next + kLineBytes);
    }
    draw(*triangles[i]);
  }
}

// for_each_block of a triangle whose extent is kMostExtent at most and that does not reach beyond
// the map on the right or below.
template <typename Visit>
HWY_INLINE std::uint64_t for_each_block_of_small(const MapTriangle& triangle, int x_low, int x_high,
                                                 int y_low, int y_high, int y, Visit&& visit) {
  BlockSides sides(triangle);
  std::uint64_t texels = 0;
  const int first_row = y / kBlockEdge;
  const int begin = std::max(first_row, (y_low >> 8) / kBlockEdge);
  const int end =
      std::min(first_row + TriangleRows::kRows / kBlockEdge - 1, (y_high >> 8) / kBlockEdge);
  for (int row = begin; row <= end; ++row) {
    for (int column = std::max(0, x_low >> 8) / kBlockEdge; column <= (x_high >> 8) / kBlockEdge;
         ++column) {
      sides.place(column, row);
      std::size_t covered = 0;
      for (int lane = 0; lane < kBlock; lane += kLanes) {
        covered += hn::CountTrue(kTag, sides.covered(0, lane));
      }
      if (covered == 0) continue;
      texels += covered;
      visit(column, row - first_row, sides);
    }
  }
  return texels;
}

// Calls visit(column, row, texels) for the blocks of a band that a triangle may cover texels of:
// row of blocks in the band, and what is covered there: texels.covered(x, lane). \param y  of the
// band's first row \return texels covered
template <typename Visit>
HWY_INLINE std::uint64_t for_each_block(const MapTriangle& triangle, int size, int y,
                                        Visit&& visit) {
  const auto& [a, b, c] = triangle.corners;
  const auto [x_low, x_high] = std::minmax({a.x, b.x, c.x});
  const auto [y_low, y_high] = std::minmax({a.y, b.y, c.y});
  if (std::max(x_high - x_low, y_high - y_low) <= BlockSides::kMostExtent &&
      std::max(x_high, y_high) < 256 * size) {
    return for_each_block_of_small(triangle, x_low, x_high, y_low, y_high, y, visit);
  }
  TriangleRows rows;
  rows.cover(triangle, size, y);
  float texels = 0.0F;
  for (int row = 0; row < TriangleRows::kRows / kBlockEdge; ++row) {
    const BlockRows of_blocks(rows, row * kBlockEdge);
    if (of_blocks.texels == 0.0F) continue;
    texels += of_blocks.texels;
    const int end = (static_cast<int>(of_blocks.x_end) + kBlockEdge - 1) / kBlockEdge;
    for (int column = static_cast<int>(of_blocks.x_begin) / kBlockEdge; column < end; ++column) {
      visit(column, row, of_blocks);
    }
  }
  return static_cast<std::uint64_t>(texels);
}

// 1/w of a triangle in a block, kept within what is drawn of it.
HWY_INLINE V inverse_w(const MapTriangle& triangle, const BlockPlane& plane, int lane) {
  const V low = set(static_cast<float>(triangle.inverse_low));
  const V high = set(static_cast<float>(triangle.inverse_high));
  return hn::Min(hn::Max(plane.at(lane), low), high);
}

}  // namespace
}  // namespace HWY_NAMESPACE
}  // namespace wedgesim::functional
HWY_AFTER_NAMESPACE();

#endif  // WEDGESIM_FUNCTIONAL_RASTER_MAP_BLOCKS_SIMD_H
