#include "functional/raster/volume_rows.h"

#include <algorithm>
#include <cmath>

#include "functional/raster/spans.h"

namespace wedgesim::functional {
namespace {

constexpr double kPad = 1.0 / 64.0;  // pixels around a hull: more than its rounding

SideRows::Span tiles_of(int x_begin, int x_end) {
  return x_begin < x_end ? SideRows::Span{x_begin / kTile, (x_end + kTile - 1) / kTile}
                         : SideRows::Span{};
}

// Tiles that a convex outline touches between two heights.
SideRows::Span hull_tiles(const std::vector<glm::dvec2>& hull, double top, double bottom,
                          int width) {
  double low = 1e300;
  double high = -1e300;
  for (std::size_t i = 0; i < hull.size(); ++i) {
    const glm::dvec2& a = hull[i];
    const glm::dvec2& b = hull[i + 1 < hull.size() ? i + 1 : 0];
    if (std::max(a.y, b.y) < top || std::min(a.y, b.y) > bottom) continue;
    const double slope = (b.x - a.x) / (b.y - a.y);
    const auto at = [&](const glm::dvec2& end) {
      const double y = std::clamp(end.y, top, bottom);
      return y == end.y ? end.x : a.x + (y - a.y) * slope;
    };
    low = std::min({low, at(a), at(b)});
    high = std::max({high, at(a), at(b)});
  }
  if (!(low <= high)) return {};
  // Pixels with their centres in [low, high].
  const double begin = std::clamp(std::ceil(low - kPad - 0.5), 0.0, static_cast<double>(width));
  const double end =
      std::clamp(std::floor(high + kPad - 0.5) + 1.0, 0.0, static_cast<double>(width));
  return tiles_of(static_cast<int>(begin), static_cast<int>(end));
}

}  // namespace

SideRows side_rows(const ScreenSide& side, int width, int height, int row, bool umbra, bool wedge) {
  SideRows rows;
  const int y_begin = kTile * row;
  const int y_end = std::min(height, y_begin + kTile);
  if (umbra && !side.umbra.outline.empty()) {
    int x_begin = width;
    int x_end = 0;
    for_each_span(side.umbra.outline, width, y_begin, y_end, [&](int y, int x0, int x1) {
      rows.umbra[static_cast<std::size_t>(y - y_begin)] = {x0, x1};
      x_begin = std::min(x_begin, x0);
      x_end = std::max(x_end, x1);
    });
    rows.umbra_tiles = tiles_of(x_begin, x_end);
  }
  if (wedge && !side.wedge.hull.empty()) {
    const auto tiles = [&](const std::vector<glm::dvec2>& hull) {
      return hull_tiles(hull, y_begin + 0.5 - kPad, y_end - 0.5 + kPad, width);
    };
    rows.wedge_tiles = tiles(side.wedge.hull);
    for (std::size_t half = 0; half < 2 && side.wedge.in_halves; ++half) {
      rows.half_tiles[half] = tiles(side.wedge.half_hulls[half]);
    }
  }
  return rows;
}

SideRows::Span joined(SideRows::Span a, SideRows::Span b) {
  if (a.empty()) return b;
  if (b.empty()) return a;
  return {std::min(a.begin, b.begin), std::max(a.end, b.end)};
}

std::uint64_t covered_pixels(const SideRows& rows, int column) {
  std::uint64_t bits = 0;
  for (std::size_t y = 0; y < kTile; ++y) {
    const int begin = std::clamp(rows.umbra[y].begin - kTile * column, 0, kTile);
    const int end = std::clamp(rows.umbra[y].end - kTile * column, 0, kTile);
    if (begin >= end) continue;
    const std::uint64_t row = (std::uint64_t{1} << end) - (std::uint64_t{1} << begin);
    bits |= row << (kTile * y);
  }
  return bits;
}

FormRange form_range(const WindowForm& form, int column, int row, const DepthTiles::Tile& tile) {
  constexpr double kReach = 0.5 * kTile - 0.5;  // from the middle to the outer pixels' centres
  constexpr double kRounding = 1e-6;            // some steps of single precision
  FormRange range;
  const double x = kTile * column + 0.5 * kTile;
  const double y = kTile * row + 0.5 * kTile;
  range.middle = form.x * x + form.y * y + form.z * tile.z_min + form.w;
  const double around = kReach * (std::abs(form.x) + std::abs(form.y));
  const double deeper = form.z * (tile.z_max - tile.z_min);
  range.low = range.middle - around + std::min(deeper, 0.0);
  range.high = range.middle + around + std::max(deeper, 0.0);
  range.doubt = kRounding * (std::abs(range.middle) + around + std::abs(deeper));
  return range;
}

bool is_culled(const ScreenWedge& wedge, int column, int row, const DepthTiles::Tile& tile) {
  return std::any_of(wedge.planes.begin(), wedge.planes.end(), [&](const WindowForm& plane) {
    const FormRange range = form_range(plane, column, row, tile);
    return range.high < -range.doubt;
  });
}

bool half_is_culled(const ScreenSide& side, bool inner, int column, int row,
                    const DepthTiles::Tile& tile) {
  const FormRange range = form_range(side.plane, column, row, tile);
  return inner == side.minus ? range.low > range.doubt : range.high < -range.doubt;
}

}  // namespace wedgesim::functional
