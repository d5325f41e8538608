#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "functional/geometry/receiver_plane.h"
#include "functional/geometry/sweep_line.h"
#include "functional/methods/method.h"

namespace wedgesim::functional {

/// A convex area of a plane with an intensity that is linear over it.
struct PlaneCell {
  using Side = std::array<GridPoint, 2>;  // inside on the left
  std::array<Side, 4> sides{};
  int side_count = 0;
  std::array<glm::dvec2, 4> corners{};  // in steps of the grid, as many as sides
  double at_corner = 0.0;               // intensity at corner 0
  glm::dvec2 gradient{0.0};
  float low = 0.0F;  // limits of the intensity
  float high = 0.0F;
};

PlaneCell make_triangle(const std::array<GridPoint, 3>& corners,
                        const std::array<float, 3>& intensity);
PlaneCell make_trapezoid(const Trapezoid& trapezoid, float intensity);

/// Draws cells of a receiver plane, each over those before it: a pixel of the plane gets one minus
/// the intensity at its centre. Which cell holds a centre is decided on the plane's grid by exact
/// tests, so cells that share a side, or a part of one, leave no crack and share no pixel.
/// Pixels of objects that cast keep their value. Adds to the accesses a z read for each pixel that
/// a cell covers and a write for each it is drawn to, 4 bytes a word.
void draw_on_plane(const MethodInput& input, const ReceiverPlane& plane,
                   std::span<const PlaneCell> cells, Visibility& result);

}  // namespace wedgesim::functional
