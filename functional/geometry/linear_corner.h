#pragma once

#include <array>
#include <cstddef>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <glm/vec4.hpp>

#include "functional/geometry/extent.h"
#include "functional/geometry/linear_wedge.h"

namespace wedgesim::functional {

/// Of an edge of a silhouette loop: its front plane, then its back plane.
struct EdgePlanes {
  glm::dvec3 normal;                     // of the shadow quad, unit, into the shadow
  std::array<std::size_t, 2> touched{};  // of light_corners
  std::array<glm::dvec3, 2> touch;       // points of the light, relative to its centre
  std::array<glm::dvec4, 2> planes;      // unit normals, into the wedge
};

/// The edges that end and start at a corner of a loop. Places are relative to the light's centre.
struct CornerEdges {
  const EdgePlanes& ending;
  const EdgePlanes& starting;
  glm::dvec3 at, ending_begin, starting_end;
  glm::dvec3 away() const { return glm::normalize(at); }
};

/// One corner of a loop: the direction in which the front planes of its two edges meet, and the
/// side plane through that line and the one of the back planes, with the edge that ends here on its
/// positive side.
struct CornerPlanes {
  LinearCorner decided;
  glm::dvec3 front;      // unit
  glm::dvec4 side;       // unit normal
  glm::dvec3 direction;  // unit, in the side plane, across the penumbra (Paper I, 4.1)
};

/// \param light_centre  world space, in which the side plane is
CornerPlanes corner_between(const CornerEdges& edges, const glm::dvec3& light_centre,
                            const EndPlane& end_plane);

}  // namespace wedgesim::functional
