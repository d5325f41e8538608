#pragma once

#include <array>
#include <glm/vec3.hpp>

namespace wedgesim::model::datapath {

/// An orthonormal frame about the centre of a spherical light, in radii, in which a silhouette edge
/// has two of three coordinates in common: `along` the edge, `out` from the centre to the edge's
/// line, and their normal.
struct DiscFrame {
  glm::dvec3 along{0.0}, out{0.0}, normal{0.0};
  double distance = 0.0;         // of the edge's line from the centre
  std::array<double, 2> ends{};  // the ends' coordinates along the edge, increasing
};

/// \param begin, end  light space, radii; an edge without length lies along the way to it
DiscFrame disc_frame(const glm::dvec3& begin, const glm::dvec3& end);

}  // namespace wedgesim::model::datapath
