#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functional/geometry/grid_point.h"

namespace wedgesim::functional {

/// A directed segment; the winding number on its left is greater by `weight` than on its right.
struct GridSegment {
  GridPoint begin, end;
  int weight = 1;
};

/// Segments cut where they meet: edges touch at their ends alone.
struct Arrangement {
  /// From `begin`, the lesser vertex, to `end`; `rise` is the winding number above it (to the
  /// left) less that below it. Never 0.
  struct Edge {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    int rise = 0;
  };
  std::vector<GridPoint> vertices;  // in order, each of some edge
  std::vector<Edge> edges;          // by their begin, then counter-clockwise about it
};

/// Cuts segments at their intersections, rounded to the grid of even coordinates, and lets every
/// segment run through the vertices whose grid square it crosses. So no rounding makes a new
/// intersection (snap rounding; Hobby 1999), closed loops stay closed, and all decisions are exact.
/// \param segments  ends with even coordinates
Arrangement arrange(std::span<const GridSegment> segments);

}  // namespace wedgesim::functional
