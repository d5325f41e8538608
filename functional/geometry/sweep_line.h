#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "functional/geometry/arrangement.h"

namespace wedgesim::functional {

/// The area between two edges and two vertical lines.
struct Trapezoid {
  std::array<GridPoint, 2> lower, upper;  // edges, each from left to right
  std::int32_t x_begin = 0;
  std::int32_t x_end = 0;
};

/// What a sweep line finds.
struct Sweep {
  std::vector<int> below;  // winding number below each edge, to its right
  /// The area of winding numbers of at least `full`, cut wherever an edge on its border ends.
  std::vector<Trapezoid> trapezoids;
  /// Pairs of vertices that see each other across an area of winding number 1 to full − 1: they
  /// connect what is not connected by edges, so that each such area has one outline.
  std::vector<std::array<std::uint32_t, 2>> bridges;
};

/// Passes over an arrangement from left to right, with the list of the edges that the sweep line
/// cuts, and counts windings from below. Edges are compared by exact arithmetic alone.
/// \param full  at least 1
/// Source: the rings' paper, 3.1 (winding numbers, trapezoids) and 3.2.
Sweep sweep_line(const Arrangement& arrangement, int full);

}  // namespace wedgesim::functional
