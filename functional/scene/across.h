#pragma once

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec3.hpp>

namespace wedgesim::functional {

/// Two unit vectors across a unit vector `axis` and across each other: u x v = axis.
struct Across {
  explicit Across(const glm::dvec3& axis)
      : u(glm::normalize(glm::cross(
            axis, std::abs(axis.x) < 0.6 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0)))),
        v(glm::cross(axis, u)) {}

  glm::dvec3 u, v;
};

}  // namespace wedgesim::functional
