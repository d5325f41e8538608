#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// How far the rounding of the planes of `linear` wedges, made in double precision, may move what a
/// wedge gives at a pixel. A front or back plane comes from the edge and a point of the light, a
/// side plane from the lines in which the front and the back planes of neighbours meet: where
/// planes are nearly one, or their lines are, little of a plane is left at the receiver. A bound to
/// first order, from the trace's planes and its light alone.
class LinearRounding {
 public:
  explicit LinearRounding(const traces::TraceView& trace);

  /// \param wedge  of kind `linear`
  /// \param x, y   the pixel's centre, pixels
  /// \param z      window depth
  /// \return       units of full light, 1 where a plane may be decided either way; 0 outside
  double operator()(std::uint32_t wedge, double x, double y, double z) const;

 private:
  // A plane's normal may be turned by `turn`, about a point at `distance` from the light.
  struct Loss {
    double turn = 0.0, distance = 0.0;
  };
  using Losses = std::array<Loss, 4>;           // front, back, left, right
  using Corner = std::array<std::uint32_t, 2>;  // the wedge that ends there, and the next
  std::vector<Corner> corners() const;
  glm::dvec3 vertex(std::uint32_t wedge, std::size_t side) const;
  void lose_edges(const std::vector<Corner>& corners);
  void lose_sides(const Corner& corner);
  glm::dvec3 touched(std::uint32_t wedge, std::size_t side) const;

  const traces::TraceView& trace_;
  std::vector<std::array<glm::dvec3, 2>> ends_;  // of each wedge's edge, from the light's centre
  std::vector<Losses> losses_;                   // of each wedge
  // Wedges with a side that may be anywhere, and their neighbours, which may be in their place.
  std::vector<bool> lost_;
};

}  // namespace wedgesim::reports::stress
