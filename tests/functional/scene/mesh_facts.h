#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <set>
#include <utility>

#include "functional/scene/manifold.h"
#include "functional/scene/scene.h"
#include "functional/scene/weld.h"

namespace wedgesim::functional {

/// Vertices minus edges plus triangles of a welded mesh: 2 a sphere, 0 a ring, summed over parts.
inline long euler_number(const Mesh& mesh) {
  std::set<std::pair<std::uint32_t, std::uint32_t>> edges;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      edges.insert(std::minmax({t[k], t[(k + 1) % 3]}));
    }
  }
  return static_cast<long>(mesh.positions.size()) - static_cast<long>(edges.size()) +
         static_cast<long>(mesh.triangles.size());
}

inline double smallest_area(const Mesh& mesh) {
  double least = 1e300;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t[0]];
    const glm::dvec3 normal = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    least = std::min(least, 0.5 * glm::length(normal));
  }
  return least;
}

/// The volume of a closed mesh of triangles that all have an area; a failure reads as NaN.
inline double sound_volume(const Mesh& mesh) {
  const Mesh joined = welded(mesh);
  return examine(joined).closed() && smallest_area(joined) > 0.0 ? signed_volume(joined) : NAN;
}

}  // namespace wedgesim::functional
