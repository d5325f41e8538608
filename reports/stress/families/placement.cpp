#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

Case offset(std::uint64_t seed, double sizes) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  const double around = stage.random.between(0.0, 6.28);
  const double up = stage.random.between(-0.9, 0.9);
  const double out = std::sqrt(1.0 - up * up);
  const glm::dvec3 way =
      sizes * kSize * glm::dvec3(out * std::cos(around), up, out * std::sin(around));
  functional::Scene& scene = stage.result.scene;
  for (functional::Object& object : scene.objects) {
    for (glm::dvec3& p : object.mesh.positions) p += way;
  }
  scene.light.centre += way;
  scene.camera.eye += way;
  scene.camera.target += way;
  return std::move(stage.result);
}

Case scale(std::uint64_t seed, double factor) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  functional::Scene& scene = stage.result.scene;
  for (functional::Object& object : scene.objects) {
    for (glm::dvec3& p : object.mesh.positions) p *= factor;
  }
  scene.light.centre *= factor;
  scene.light.half_u *= factor;
  scene.light.half_v *= factor;
  scene.light.radius *= factor;
  scene.camera.eye *= factor;
  scene.camera.target *= factor;
  scene.camera.near_plane *= factor;
  scene.camera.far_plane *= factor;
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> placement_families() {
  return {
      {"offset",
       "distance from the origin over the light's height",
       "",
       decades(0, 11),
       {1e4, 1e5},
       offset},
      {"scale-up", "factor on all lengths", "", decades(0, 10), {1e6, 1e6}, scale},
      {"scale-down", "factor on all lengths", "", decades(0, -12), {1e-6, 1e-6}, scale},
  };
}

}  // namespace wedgesim::reports::stress
