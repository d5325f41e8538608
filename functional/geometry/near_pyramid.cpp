#include "functional/geometry/near_pyramid.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

namespace wedgesim::functional {
namespace {

double distance(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

glm::dvec4 plane_through(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c,
                         const glm::dvec3& inside) {
  const glm::dvec3 n = glm::normalize(glm::cross(b - a, c - a));
  const glm::dvec4 plane(n, -glm::dot(n, a));
  return distance(plane, inside) < 0.0 ? -plane : plane;
}

template <typename Points>
bool all_behind(const glm::dvec4& plane, const Points& points) {
  return std::all_of(points.begin(), points.end(),
                     [&](const glm::dvec3& p) { return distance(plane, p) < 0.0; });
}

}  // namespace

NearPyramid::NearPyramid(const Window& window) {
  corners_[0] = window.eye;
  for (std::size_t i = 0; i < 4; ++i) corners_[i + 1] = window.near_rectangle[i];
  glm::dvec3 middle(0.0);
  for (const glm::dvec3& p : corners_) middle += 0.2 * p;
  // The near plane first: most of a scene is behind it.
  planes_[0] = plane_through(corners_[1], corners_[2], corners_[3], middle);
  for (std::size_t i = 0; i < 4; ++i) {
    planes_[i + 1] = plane_through(window.eye, corners_[i + 1], corners_[(i + 1) % 4 + 1], middle);
  }
}

bool NearPyramid::may_meet(const WorldWedge& volume) const {
  for (const glm::dvec4& plane : planes_) {
    if (all_behind(plane, volume.vertices)) return false;
  }
  for (const glm::dvec4& plane : volume.planes) {
    if (all_behind(plane, corners_)) return false;
  }
  return true;
}

bool NearPyramid::meets(std::span<const glm::dvec3> polygon) const {
  for (const glm::dvec4& plane : planes_) {
    if (all_behind(plane, polygon)) return false;
  }
  std::vector<glm::dvec3> left(polygon.begin(), polygon.end());
  for (const glm::dvec4& plane : planes_) {
    std::vector<glm::dvec3> kept;
    for (std::size_t i = 0; i < left.size(); ++i) {
      const glm::dvec3& a = left[i];
      const glm::dvec3& b = left[(i + 1) % left.size()];
      const double da = distance(plane, a);
      const double db = distance(plane, b);
      if (da >= 0.0) kept.push_back(a);
      if ((da >= 0.0) != (db >= 0.0)) kept.push_back(a + (da / (da - db)) * (b - a));
    }
    if (kept.empty()) return false;
    left = std::move(kept);
  }
  return true;
}

}  // namespace wedgesim::functional
