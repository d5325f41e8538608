#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "functional/geometry/arrangement.h"
#include "functional/geometry/sweep_line.h"

namespace wedgesim::functional {

/// The hard shadows of several light samples, merged. Ring k, from 1 to `samples`, bounds the area
/// where at least k samples are hidden; an edge with counts `below` and `above` belongs to every
/// ring from the lesser plus 1 to the greater.
struct Rings {
  struct Edge {
    std::uint32_t begin = 0;
    std::uint32_t end = 0;
    int below = 0;  // samples hidden on the right of begin to end
    int above = 0;  // and on the left
  };
  /// The rings that meet in a vertex. At a crossing lines of different rings touch: the vertex
  /// links them.
  struct Point {
    int lowest = 0;
    int highest = 0;
    bool crossing = false;
  };
  int samples = 0;
  std::vector<GridPoint> vertices;
  std::vector<Point> points;  // of each vertex
  std::vector<Edge> edges;
  std::vector<std::array<std::uint32_t, 2>> bridges;  // across areas of the penumbra (sweep_line.h)
  std::vector<Trapezoid> umbra;                       // where all samples are hidden
};

/// Merges silhouettes by the sweep line. An edge of the outermost or innermost ring whose ends are
/// both crossings gets its middle as a point of its own, with the ring's own intensity.
/// \param silhouettes  of each sample: closed outlines, shadow on the left
/// Source: the rings' paper, 3.2.
Rings merge_silhouettes(std::span<const std::vector<GridSegment>> silhouettes);

/// Shadow intensity of a vertex, 0 lit to 1 hidden, as the area beside it sees it where `count`
/// samples are hidden: (k − 1)/(samples − 1) on ring k; at a crossing the mean of two rings, of
/// more the two that are next to the area.
double intensity(const Rings& rings, std::uint32_t vertex, int count);

}  // namespace wedgesim::functional
