#include "functional/light/clearance.h"

#include <fmt/format.h>

#include <glm/geometric.hpp>

#include "base/error.h"
#include "functional/light/coverage.h"

namespace wedgesim::functional {

void check_light_is_clear(const Mesh& mesh, const Light& light) {
  const glm::dmat4 to_light = light_from_world(light);
  for (const glm::dvec3& p : mesh.positions) {
    const glm::dvec3 q(to_light * glm::dvec4(p, 1.0));
    const bool clear = light.shape == LightShape::rectangle ? q.z > 0.0
                       : light.shape == LightShape::sphere  ? glm::dot(q, q) > 1.0
                                                            : glm::dot(q, q) > 0.0;
    if (!clear) {
      throw InputError(
          mesh.name,
          fmt::format("vertex ({:.6g}, {:.6g}, {:.6g}) is not clear of the light", p.x, p.y, p.z),
          light.shape == LightShape::rectangle ? "casters in front of the rectangle's plane"
                                               : "casters outside the light");
    }
  }
}

}  // namespace wedgesim::functional
