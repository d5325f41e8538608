#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>
#include <utility>

#include "functional/scene/primitives.h"
#include "functional/scene/transform.h"
#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

constexpr double kRadius = 1.2;

// The camera looks along the plane of one edge's shadow, past the edge's end, and sees a strip
// around the edge's penumbra, however thin: there a step of stored z changes little.
Case small_light(std::uint64_t seed, double ratio) {
  Stage stage = make_stage(seed, kRadius * ratio);
  const functional::Light& light = stage.light();
  const std::vector<Slope> corners =
      ring(stage.aim, kRadius / kDepth, 4, stage.random.between(0.0, 1.5));
  const std::vector<glm::dvec3> loop = below(light, corners, kDepth);
  add_caster(stage.result, between_pyramids(light, stage.aim, loop));

  const glm::dvec3 along = glm::normalize(loop[1] - loop[0]);
  const double penumbra = 2.0 * kRadius * ratio * (kSize - kDepth) / kDepth;
  // At ratio 0 as at the smallest before it.
  const double width = ratio > 0.0 ? penumbra : 1e-9;
  functional::Camera& camera = stage.camera();
  camera.target = below(light, 0.5 * (corners[0] + corners[1]), kSize);
  camera.eye = camera.target + kSize * glm::dvec3(0.0, 1.0, 0.0) - 6.0 * along;
  camera.up = along;
  camera.field_of_view_degrees =
      glm::degrees(2.0 * std::atan(1.5 * width / glm::distance(camera.eye, camera.target)));
  return std::move(stage.result);
}

// Near the light, so that the penumbra is large.
Case large_light(std::uint64_t seed, double ratio) {
  constexpr double kNear = 3.0;
  Stage stage = make_stage(seed, kRadius);
  const double radius = kRadius / ratio / kNear;
  const std::vector<glm::dvec3> loop =
      below(stage.light(), ring(stage.aim, radius, 4, stage.random.between(0.0, 1.5)), kNear);
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

// A box below the light: smaller than it while there is a gap, round it from there on.
Case touching_light(std::uint64_t seed, double gap) {
  constexpr double kSmall = 0.5;
  Stage stage = make_stage(seed, kSmall);
  functional::Light& light = stage.light();
  double bottom = light.centre.y;
  if (light.shape == functional::LightShape::rectangle) {
    light.half_u = {kSmall, 0.0, 0.0};
    light.half_v = {0.0, 0.0, kSmall};
  } else {
    bottom -= kSmall;
  }
  const double width = (gap < 0.0 ? 3.0 : 0.75) * kSmall;
  const double height = (gap < 0.0 ? 6.0 : 0.5) * kSmall;
  functional::Placement placement;
  placement.position = {light.centre.x, bottom - gap * kSmall - height, light.centre.z};
  add_caster(stage.result,
             functional::placed(functional::make_box({width, height, width}), placement));
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> light_families() {
  return {
      {"small-light",
       "radius of the light over that of the occluder; 0 is a point",
       "",
       decades(0, -9, {0.0}),
       {1e-4, 1e-6},
       small_light},
      {"large-light",
       "radius of the light over that of the occluder",
       "",
       decades(0, 6),
       {1e2, 1e3},
       large_light},
      {"touching-light",
       "gap between caster and light in light radii; below 0 the caster reaches "
       "round the light",
       "",
       decades(0, -9, {0.0, -0.5, -3.0}),
       {-3.0, -3.0},
       touching_light,
       true},
  };
}

}  // namespace wedgesim::reports::stress
