#include "functional/scene/origin.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

// Three bits lost by differences of coordinates do no harm: most scenes stay as they are.
constexpr double kFar = 8.0;

}  // namespace

glm::dvec3 best_origin(const Scene& scene) {
  glm::dvec3 low = glm::min(scene.camera.eye, scene.light.centre);
  glm::dvec3 high = glm::max(scene.camera.eye, scene.light.centre);
  for (const Object& object : scene.objects) {
    for (const glm::dvec3& p : object.mesh.positions) {
      low = glm::min(low, p);
      high = glm::max(high, p);
    }
  }
  const glm::dvec3 farthest = glm::max(glm::abs(low), glm::abs(high));
  const double size = glm::length(high - low);
  const bool far = std::max({farthest.x, farthest.y, farthest.z}) > kFar * size;
  return far ? scene.camera.eye : glm::dvec3(0.0);
}

Scene taken_from(const Scene& scene, const glm::dvec3& origin) {
  Scene moved = scene;
  moved.camera.eye -= origin;
  moved.camera.target -= origin;
  moved.light.centre -= origin;
  for (Object& object : moved.objects) {
    for (glm::dvec3& p : object.mesh.positions) p -= origin;
  }
  return moved;
}

}  // namespace wedgesim::functional
