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

// The camera looks past the end of an edge, along the plane of its shadow but for twice the
// penumbra's width, and sees a strip around the penumbra, however thin: it is the same picture at
// every ratio, and a step of stored z changes little in it.
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
  const glm::dvec3 to_light = light.centre - camera.target;
  const glm::dvec3 off = glm::normalize(glm::cross(along, to_light));
  camera.eye = light.centre - 6.0 * along + 2.0 * width * off;
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

constexpr double kSmall = 0.5;

// A box so far below a small light, in radii of it; sizes in radii, too.
Case box_below(std::uint64_t seed, double gap, double box_width, double box_height) {
  Stage stage = make_stage(seed, kSmall);
  functional::Light& light = stage.light();
  double bottom = light.centre.y;
  if (light.shape == functional::LightShape::rectangle) {
    light.half_u = {kSmall, 0.0, 0.0};
    light.half_v = {0.0, 0.0, kSmall};
  } else {
    bottom -= kSmall;
  }
  const double width = box_width * kSmall;
  const double height = box_height * kSmall;
  functional::Placement placement;
  placement.position = {light.centre.x, bottom - gap * kSmall - height, light.centre.z};
  add_caster(stage.result,
             functional::placed(functional::make_box({width, height, width}), placement));
  return std::move(stage.result);
}

// Smaller than the light while there is a gap, round it from there on.
Case touching_light(std::uint64_t seed, double gap) {
  return gap < 0.0 ? box_below(seed, gap, 3.0, 6.0) : box_below(seed, gap, 0.75, 0.5);
}

// Always smaller than the light: a spherical one comes to hold it, a rectangle to cut it.
Case enclosing_light(std::uint64_t seed, double gap) { return box_below(seed, gap, 0.75, 0.5); }

// A rectangle of any width down to a line, over a box two of whose sides run along it. Of a line
// the `linear` wedges of the edges along it have no volume; lights of a sphere have no such shape.
Case line_light(std::uint64_t seed, double width) {
  constexpr double kSide = 1.6;
  constexpr double kHeight = 0.4;
  Stage stage = make_stage(seed, kLightRadius);
  functional::Light& light = stage.light();
  light.shape = functional::LightShape::rectangle;
  light.half_u = {kLightRadius, 0.0, 0.0};
  light.half_v = {0.0, 0.0, kLightRadius * width};
  light.radius = 0.0;
  const glm::dvec3 middle = below(light, stage.aim, kDepth);
  functional::Placement placement;
  placement.position = {middle.x, middle.y - kHeight, middle.z};
  add_caster(stage.result,
             functional::placed(functional::make_box({kSide, kHeight, kSide}), placement));
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> light_families() {
  return {
      {"small-light",
       "radius of the light over that of the occluder; 0 is a point",
       "",
       decades(0, -12, {0.0}),
       {1e-4, 1e-6},
       small_light},
      {"line-light",
       "width of a rectangular light over its length",
       "",
       decades(0, -12, {1e-14, 1e-16, 1e-18, 1e-24}),
       {1e-4, 1e-6},
       line_light},
      {"large-light",
       "radius of the light over that of the occluder",
       "",
       decades(0, 7),
       {1e2, 1e3},
       large_light},
      {"touching-light",
       "gap between caster and light in light radii; below 0 the caster reaches "
       "round the light",
       "",
       {1.0, 0.8, 0.7, 0.6, 0.5, 0.3, 0.1, 0.03, 0.01, 0.005, 0.002, 1e-3, 1e-6, 0.0, -0.5, -3.0},
       {-3.0, -3.0},
       touching_light,
       true,
       0.0,
       {1e-3, 1e-6, 0.0, -0.5, -3.0}},  // refused: the penumbra spans a half-space
      {"enclosing-light",
       "gap between caster and light in light radii; below 0 a spherical light comes to hold the "
       "caster",
       "",
       {1.0, 0.5, 0.1, 0.0, -0.25, -0.5, -1.25},
       {-1.25, -1.25},
       enclosing_light,
       true,
       0.0,
       {0.0, -0.25, -0.5, -1.25}},
  };
}

}  // namespace wedgesim::reports::stress
