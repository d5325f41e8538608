#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include "functional/geometry/rings.h"

namespace wedgesim::functional {

/// A triangle with the shadow intensity of its corners, to be interpolated between them.
struct ShadedTriangle {
  std::array<std::uint32_t, 3> corners{};  // vertices of the rings, counter-clockwise
  std::array<float, 3> intensity{};
  int hidden = 0;  // samples
};

struct RingTriangles {
  std::vector<ShadedTriangle> strips;  // between neighbouring rings, without overlap or gap
  /// At crossings of the innermost and the outermost ring, whose intensity is not that of umbra and
  /// light: triangles into these, drawn over them.
  std::vector<ShadedTriangle> mends;
};

/// Triangulates the penumbra strip by strip. The walk begins where two rings meet, or at a bridge,
/// and takes the nearer of the next points on either ring. A triangle that would run back or cut
/// what is not in the strip is not taken; where neither point can be, the bay is filled by
/// triangles of one ring. Source: the rings' paper, 3.3. Differs: wrong triangles are never drawn,
/// by exact tests, instead of being removed afterwards.
RingTriangles triangulate_rings(const Rings& rings);

}  // namespace wedgesim::functional
