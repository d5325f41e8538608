#include "reports/stress/families/penumbra.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "functional/geometry/extent.h"

namespace wedgesim::reports::stress {

glm::dvec3 Penumbra::towards(double angle) const {
  return std::cos(angle) * to_light + std::sin(angle) * into_shadow;
}

glm::dvec3 Penumbra::normal(double angle) const {
  return std::cos(angle) * into_shadow - std::sin(angle) * to_light;
}

Penumbra penumbra_of(const functional::Light& light, const glm::dvec3& begin, const glm::dvec3& end,
                     const glm::dvec3& shadow) {
  Penumbra penumbra{};
  penumbra.middle = 0.5 * (begin + end);
  const glm::dvec3 along = glm::normalize(end - begin);
  const auto across = [&](const glm::dvec3& p) {
    const glm::dvec3 from = p - penumbra.middle;
    return from - glm::dot(from, along) * along;
  };
  const glm::dvec3 to_light = across(light.centre);
  penumbra.to_light = glm::normalize(to_light);
  penumbra.into_shadow = glm::cross(along, penumbra.to_light);
  if (glm::dot(penumbra.into_shadow, across(shadow)) < 0.0) {
    penumbra.into_shadow = -penumbra.into_shadow;
  }
  if (light.shape == functional::LightShape::sphere) {
    penumbra.most = std::asin(light.radius / glm::length(to_light));
    penumbra.least = -penumbra.most;
    return penumbra;
  }
  for (const glm::dvec3& corner : functional::light_corners(light)) {
    const glm::dvec3 p = across(corner);
    const double angle =
        std::atan2(glm::dot(p, penumbra.into_shadow), glm::dot(p, penumbra.to_light));
    penumbra.least = std::min(penumbra.least, angle);
    penumbra.most = std::max(penumbra.most, angle);
  }
  return penumbra;
}

}  // namespace wedgesim::reports::stress
