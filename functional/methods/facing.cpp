#include "functional/methods/facing.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <glm/geometric.hpp>

namespace wedgesim::functional {

std::vector<Facing> find_facings(const MethodInput& input, const glm::dvec3& centre,
                                 double radius) {
  const std::vector<std::uint32_t>& first_triangle = input.depth.first_triangle;
  std::vector<Facing> facings(first_triangle.back(), Facing::light);
  for (std::size_t i = 0; i < input.scene.objects.size(); ++i) {
    if (!input.scene.objects[i].casts) continue;
    const Mesh& mesh = input.scene.objects[i].mesh;
    const tbb::blocked_range<std::size_t> all(0, mesh.triangles.size(), 1024);
    tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& some) {
      for (std::size_t t = some.begin(); t < some.end(); ++t) {
        const auto& corner = mesh.triangles[t];
        const glm::dvec3& p = mesh.positions[corner[0]];
        const glm::dvec3 normal =
            glm::cross(mesh.positions[corner[1]] - p, mesh.positions[corner[2]] - p);
        const double side = glm::dot(normal, input.window.eye - p) < 0.0 ? -1.0 : 1.0;
        const double height = side * glm::dot(normal, centre - p);
        if (height > 0.0) continue;
        facings[first_triangle[i] + t] =
            height < -radius * glm::length(normal) ? Facing::away : Facing::away_from_its_centre;
      }
    });
  }
  return facings;
}

}  // namespace wedgesim::functional
