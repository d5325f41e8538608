#include "functional/scene/origin.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <limits>

namespace wedgesim::functional {
namespace {

// Three bits lost by differences of coordinates do no harm: most scenes stay as they are.
constexpr double kFar = 8.0;
// Planes through the light lose as many digits as it is farther from the origin than from a caster.
constexpr double kFarFromCaster = 1024.0;

double nearest_caster(const Scene& scene, const glm::dvec3& from) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      nearest = std::min(nearest, glm::distance(p, from));
    }
  }
  return nearest;
}

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
  const double to_eye = nearest_caster(scene, scene.camera.eye);
  const double to_light = nearest_caster(scene, scene.light.centre);
  const bool far = std::max({farthest.x, farthest.y, farthest.z}) > kFar * size ||
                   glm::length(scene.light.centre) > kFarFromCaster * to_light ||
                   glm::length(scene.camera.eye) > kFarFromCaster * to_eye;
  if (!far) return glm::dvec3(0.0);
  return to_light < to_eye ? scene.light.centre : scene.camera.eye;
}

Scene taken_from(const Scene& scene, const glm::dvec3& origin) {
  Scene moved = scene;
  moved.camera.eye -= origin;
  moved.camera.target -= origin;
  moved.light.centre -= origin;
  for (Light& light : moved.other_lights) light.centre -= origin;
  for (Object& object : moved.objects) {
    for (glm::dvec3& p : object.mesh.positions) p -= origin;
  }
  return moved;
}

}  // namespace wedgesim::functional
