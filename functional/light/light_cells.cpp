#include "functional/light/light_cells.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/check.h"
#include "functional/light/unit_disc.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// Of side x side cells of the square [-1, 1]².
std::vector<glm::dvec2> square_middles(int side) {
  std::vector<glm::dvec2> middles;
  for (int i = 0; i < side * side; ++i) {
    middles.emplace_back((2.0 * (i % side) + 1.0) / side - 1.0,
                         (2.0 * (i / side) + 1.0) / side - 1.0);
  }
  return middles;
}

}  // namespace

std::vector<glm::dvec3> cell_middles(const Light& light, int count, const glm::dvec3& towards) {
  if (!has_extent(light)) return {light.centre};
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(count) + 0.5)));
  const Across across(glm::normalize(towards - light.centre));
  std::vector<glm::dvec3> middles;
  for (const glm::dvec2& s : square_middles(side)) {
    if (light.shape == LightShape::rectangle) {
      middles.push_back(light.centre + s.x * light.half_u + s.y * light.half_v);
    } else {
      const glm::dvec2 q = light.radius * to_disc(s);
      middles.push_back(light.centre + q.x * across.u + q.y * across.v);
    }
  }
  return middles;
}

std::vector<Light> light_parts(const Light& light, int side) {
  WEDGESIM_CHECK(light.shape == LightShape::rectangle);
  std::vector<Light> parts;
  for (const glm::dvec2& s : square_middles(side)) {
    Light part = light;
    part.centre += s.x * light.half_u + s.y * light.half_v;
    part.half_u /= side;
    part.half_v /= side;
    parts.push_back(part);
  }
  return parts;
}

}  // namespace wedgesim::functional
