#pragma once

#include <cmath>
#include <glm/vec2.hpp>

namespace wedgesim::functional {

/// The square [-1, 1]² onto the unit disc, equal areas to equal areas, its border onto the circle
/// (Shirley and Chiu).
inline glm::dvec2 to_disc(const glm::dvec2& s) {
  if (s.x == 0.0 && s.y == 0.0) return s;
  if (std::abs(s.x) > std::abs(s.y)) {
    const double angle = M_PI / 4.0 * (s.y / s.x);
    return s.x * glm::dvec2(std::cos(angle), std::sin(angle));
  }
  const double angle = M_PI / 2.0 - M_PI / 4.0 * (s.x / s.y);
  return s.y * glm::dvec2(std::cos(angle), std::sin(angle));
}

}  // namespace wedgesim::functional
