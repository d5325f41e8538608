#pragma once

#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The edges of a mesh, by their lower and then their higher vertex. An edge of a closed
/// two-manifold has two triangles; one with less or more is there once for each pair that runs
/// along it in opposite directions and once for each triangle that is left over.
std::vector<MeshEdge> mesh_edges(const Mesh& mesh);

}  // namespace wedgesim::functional
