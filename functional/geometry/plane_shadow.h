#pragma once

#include <array>
#include <cstdint>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "functional/geometry/arrangement.h"
#include "functional/geometry/receiver_plane.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The casters of a scene over a plane, ready to be projected from many points.
class PlaneShadow {
 public:
  /// Chooses the plane's unit too: as fine as the longest shadow allows.
  /// \param lights  world space
  /// \throws InputError if a light or a caster is not where it has to be: plane, casters, lights
  PlaneShadow(const Scene& scene, ReceiverPlane& plane, std::span<const glm::dvec3> lights);

  /// The outline of the hard shadow of a point light: segments that bound the area where any caster
  /// hides it, shadow on the left, holes kept.
  /// Source: the rings' paper, 3.1; what is below the plane is cut off there.
  std::vector<GridSegment> silhouette(const glm::dvec3& light) const;

  /// The segments before their union: loops whose winding numbers count the light-facing triangles
  /// between the light and a point.
  std::vector<GridSegment> loops(const glm::dvec3& light) const;

 private:
  struct Edge {
    std::uint32_t begin, end;   // vertices, as the left triangle has them
    std::uint32_t left, right;  // triangles
  };
  struct Face {
    glm::dvec3 point, normal;
  };
  void add(const Mesh& mesh);

  const ReceiverPlane& plane_;
  std::vector<glm::dvec3> positions_;  // in the plane's axes
  std::vector<std::array<std::uint32_t, 3>> triangles_;
  std::vector<Face> faces_;  // of each triangle
  std::vector<Edge> edges_;
  std::vector<std::uint32_t> crossing_;  // triangles with vertices on both sides of the plane
};

/// The outline of the area where the winding number of closed loops is at least 1, on the left.
std::vector<GridSegment> outline_of_union(std::span<const GridSegment> loops);

}  // namespace wedgesim::functional
