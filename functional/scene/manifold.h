#pragma once

#include <cstddef>
#include <glm/vec3.hpp>
#include <optional>
#include <string>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What keeps a mesh from being a closed two-manifold. An edge is two vertices; vertices at which
/// several fans touch are fine.
struct ManifoldReport {
  std::size_t boundary_edges = 0;       // of one triangle
  std::size_t non_manifold_edges = 0;   // of more than two
  std::size_t inconsistent_edges = 0;   // of two triangles that run along it in the same direction
  std::optional<glm::dvec3> first_bad;  // the middle of the first bad edge, in triangle order

  bool closed() const { return !first_bad; }
};

/// Counts a mesh's bad edges. Equal positions are equal vertices only where `welded` made them so.
ManifoldReport examine(const Mesh& mesh);

/// The volume that the surface encloses: positive if it faces outwards.
double signed_volume(const Mesh& mesh);

/// Closed and not inside out: what require_closed demands.
bool is_sound(const Mesh& mesh);

/// \param place   named in the error, with the mesh
/// \param remark  put after the mesh's name, as " even after repair"
/// \throws InputError with the three counts and the first bad edge's position, or if the mesh is
///         inside out
void require_closed(const Mesh& mesh, const std::string& place, const std::string& remark = {});

}  // namespace wedgesim::functional
