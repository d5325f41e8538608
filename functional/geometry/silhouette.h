#pragma once

#include <cstdint>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A silhouette edge, directed so that the light-facing triangle is on its left as seen from the
/// light; ends are vertices of the mesh.
struct SilhouetteEdge {
  std::uint32_t begin = 0;
  std::uint32_t end = 0;
};

struct Silhouette {
  /// Closed loops: each edge ends where the next begins, the last where the first begins. Every
  /// edge is in exactly one loop; loops may meet at vertices of degree 4 and more (Paper V).
  std::vector<std::vector<SilhouetteEdge>> loops;
  std::vector<std::uint8_t> light_facing;  // of each triangle: 1 or 0
};

/// The silhouette of a closed two-manifold mesh as seen from a point (Paper V: possible
/// silhouettes). A triangle faces the point iff the point is strictly in front of it. Fast where
/// the mesh has its edges, which else are found anew.
Silhouette find_silhouette(const Mesh& mesh, const glm::dvec3& from);

/// The outline of any set of triangles of such a mesh: its edges have a triangle of the set on
/// their left, another on their right.
/// \param inside  of each triangle, kept as `light_facing`
Silhouette find_outline(const Mesh& mesh, std::vector<std::uint8_t> inside);

}  // namespace wedgesim::functional
