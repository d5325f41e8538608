#pragma once

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <initializer_list>
#include <span>
#include <utility>
#include <vector>

#include "functional/geometry/grid_point.h"

namespace wedgesim::functional {

/// A uniform grid of about as many square cells as there are things to find, over some points.
class CellGrid {
 public:
  CellGrid(std::span<const GridPoint> points, std::size_t things) {
    if (points.empty()) return;
    low_ = {kGridLimit, kGridLimit};
    GridPoint high{-kGridLimit, -kGridLimit};
    for (const GridPoint& p : points) {
      low_ = {std::min(low_.x, p.x), std::min(low_.y, p.y)};
      high = {std::max(high.x, p.x), std::max(high.y, p.y)};
    }
    const double width = std::max(1.0, static_cast<double>(high.x) - low_.x);
    const double height = std::max(1.0, static_cast<double>(high.y) - low_.y);
    const double size =
        std::sqrt(width * height / static_cast<double>(std::max<std::size_t>(things, 1)));
    size_ = std::max({8.0, size, width / kMostCells, height / kMostCells});
    columns_ = static_cast<int>(width / size_) + 1;
    rows_ = static_cast<int>(height / size_) + 1;
  }

  std::size_t cells() const {
    return static_cast<std::size_t>(columns_) * static_cast<std::size_t>(rows_);
  }
  std::uint32_t cell_of(const GridPoint& p) const { return cell(column(p.x), row(p.y)); }

  /// Calls visit(cell) for every cell that the convex outline comes near to; two points are a
  /// segment. Never misses a cell of a point that is within two units.
  template <typename Visit>
  void for_each_cell(std::initializer_list<GridPoint> outline, Visit&& visit) const {
    any_cell(outline, [&](std::uint32_t cell) {
      visit(cell);
      return false;
    });
  }

  /// The same until test(cell) is true; whether it ever was.
  template <typename Test>
  bool any_cell(std::initializer_list<GridPoint> outline, Test&& test) const {
    const auto [first, last] =
        std::minmax_element(outline.begin(), outline.end(),
                            [](const GridPoint& a, const GridPoint& b) { return a.x < b.x; });
    const int column_end = column(last->x + kMargin);
    if (column(first->x - kMargin) == column_end) {  // most are small
      const auto [low, high] =
          std::minmax_element(outline.begin(), outline.end(),
                              [](const GridPoint& a, const GridPoint& b) { return a.y < b.y; });
      const int row_end = row(high->y + kMargin);
      for (int r = row(low->y - kMargin); r <= row_end; ++r) {
        if (test(cell(column_end, r))) return true;
      }
      return false;
    }
    for (int c = column(first->x - kMargin); c <= column_end; ++c) {
      const double x_low = low_.x + c * size_ - kMargin;
      const double x_high = x_low + size_ + 2 * kMargin;
      double y_low = 2.0 * kGridLimit;
      double y_high = -2.0 * kGridLimit;
      const GridPoint* a = outline.end() - 1;
      for (const GridPoint& b : outline) {
        grow(*a, b, x_low, x_high, y_low, y_high);
        a = &b;
      }
      if (y_low > y_high) continue;
      const int row_end = row(y_high + kMargin);
      for (int r = row(y_low - kMargin); r <= row_end; ++r) {
        if (test(cell(c, r))) return true;
      }
    }
    return false;
  }

 private:
  static constexpr double kMostCells = 4096.0;  // each way
  static constexpr int kMargin = 3;

  int column(double x) const {
    return std::clamp(static_cast<int>(std::floor((x - low_.x) / size_)), 0, columns_ - 1);
  }
  int row(double y) const {
    return std::clamp(static_cast<int>(std::floor((y - low_.y) / size_)), 0, rows_ - 1);
  }
  std::uint32_t cell(int column, int row) const {
    return static_cast<std::uint32_t>(row * columns_ + column);
  }
  // The y of a segment within a range of x.
  static void grow(GridPoint a, GridPoint b, double x_low, double x_high, double& y_low,
                   double& y_high) {
    if (a.x > b.x) std::swap(a, b);
    if (a.x > x_high || b.x < x_low) return;
    const double slope =
        a.x == b.x ? 0.0 : (static_cast<double>(b.y) - a.y) / (static_cast<double>(b.x) - a.x);
    const double y0 = a.x >= x_low ? a.y : a.y + slope * (x_low - a.x);
    const double y1 = b.x <= x_high ? b.y : a.y + slope * (x_high - a.x);
    y_low = std::min({y_low, y0, y1});
    y_high = std::max({y_high, y0, y1});
  }

  GridPoint low_;
  double size_ = 1.0;
  int columns_ = 1;
  int rows_ = 1;
};

/// What lies in each cell of a grid: lists one behind the other.
class CellLists {
 public:
  struct Entry {
    std::uint32_t cell, item;
  };
  CellLists(std::size_t cells, std::span<const Entry> entries)
      : first_(cells + 1, 0), items_(entries.size()) {
    for (const Entry& entry : entries) ++first_[entry.cell + 1];
    for (std::size_t i = 0; i < cells; ++i) first_[i + 1] += first_[i];
    std::vector<std::uint32_t> next(first_.begin(), first_.end() - 1);
    for (const Entry& entry : entries) items_[next[entry.cell]++] = entry.item;
  }
  /// Of points, by their index.
  CellLists(const CellGrid& grid, std::span<const GridPoint> points)
      : CellLists(grid.cells(), entries_of(grid, points)) {}

  std::span<const std::uint32_t> operator[](std::size_t cell) const {
    return std::span(items_).subspan(first_[cell], first_[cell + 1] - first_[cell]);
  }

 private:
  static std::vector<Entry> entries_of(const CellGrid& grid, std::span<const GridPoint> points) {
    std::vector<Entry> entries;
    entries.reserve(points.size());
    for (std::uint32_t i = 0; i < points.size(); ++i)
      entries.push_back({grid.cell_of(points[i]), i});
    return entries;
  }

  std::vector<std::uint32_t> first_;
  std::vector<std::uint32_t> items_;
};

}  // namespace wedgesim::functional
