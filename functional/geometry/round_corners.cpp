#include "functional/geometry/round_corners.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr double kReach = 1e-3;  // of the shorter edge
// One more edge for each step below a right angle, from the first on.
constexpr double kStep = M_PI / 12.0;
constexpr int kMostEdges = 6;

// Between two vectors as they are seen along a third; 0 if one of them is not seen.
double cosine_across(glm::dvec3 a, glm::dvec3 b, const glm::dvec3& along) {
  const glm::dvec3 way = glm::normalize(along);
  a -= glm::dot(a, way) * way;
  b -= glm::dot(b, way) * way;
  const double lengths = glm::length(a) * glm::length(b);
  return lengths > 0.0 ? glm::dot(a, b) / lengths : 0.0;
}

}  // namespace

std::vector<glm::dvec3> round_corners(const std::vector<glm::dvec3>& loop,
                                      const glm::dvec3& light_centre) {
  std::vector<glm::dvec3> rounded;
  const std::size_t n = loop.size();
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec3& corner = loop[i];
    const glm::dvec3 back = loop[(i + n - 1) % n] - corner;
    const glm::dvec3 ahead = loop[(i + 1) % n] - corner;
    const double shorter = std::min(glm::length(back), glm::length(ahead));
    const double cosine = cosine_across(back, ahead, corner - light_centre);
    if (cosine <= std::sin(kStep)) {
      rounded.push_back(corner);
      continue;
    }
    const double angle = std::acos(std::min(cosine, 1.0));
    const int edges = std::min(kMostEdges, 1 + static_cast<int>((M_PI / 2.0 - angle) / kStep));
    const glm::dvec3 from = corner + kReach * shorter * glm::normalize(back);
    const glm::dvec3 to = corner + kReach * shorter * glm::normalize(ahead);
    // Along the parabola that touches both edges.
    for (int k = 0; k <= edges; ++k) {
      const double t = static_cast<double>(k) / edges;
      rounded.push_back(glm::mix(glm::mix(from, corner, t), glm::mix(corner, to, t), t));
    }
  }
  return rounded;
}

}  // namespace wedgesim::functional
