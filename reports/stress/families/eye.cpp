#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"
#include "reports/stress/families/penumbra.h"

namespace wedgesim::reports::stress {
namespace {

// Below an edge of the plate, looking past the middle of its shadow on the floor.
struct EyeBelow {
  Stage stage;
  Penumbra penumbra;

  explicit EyeBelow(std::uint64_t seed) : stage(make_stage(seed, kLightRadius)) {
    const std::vector<glm::dvec3> plate = add_plate(stage);
    penumbra = penumbra_of(stage.light(), plate[0], plate[1], 0.5 * (plate[0] + plate[2]));
  }

  static constexpr double kBehind = 1.0;

  Case seen_from(const glm::dvec3& eye) {
    functional::Camera& camera = stage.camera();
    const glm::dvec3 shadow = below(stage.light(), stage.aim, kSize);
    camera.eye = eye;
    camera.target = shadow + 0.9 * (shadow - glm::dvec3(eye.x, 0.0, eye.z));
    camera.near_plane = 0.05;
    camera.field_of_view_degrees = 30.0;
    return std::move(stage.result);
  }
};

Case eye_in_wedge(std::uint64_t seed, double distance) {
  EyeBelow view(seed);
  const Penumbra& p = view.penumbra;
  return view.seen_from(p.middle - EyeBelow::kBehind * p.towards(p.most) +
                        distance * kSize * p.normal(p.most));
}

Case eye_in_umbra(std::uint64_t seed, double distance) {
  EyeBelow view(seed);
  const Penumbra& p = view.penumbra;
  return view.seen_from(p.middle - EyeBelow::kBehind * p.towards(p.least) +
                        distance * kSize * p.normal(p.least));
}

Case eye_on_plane(std::uint64_t seed, double distance) {
  EyeBelow view(seed);
  const Penumbra& p = view.penumbra;
  const double side = view.stage.random.between(-1.0, 1.0) < 0.0 ? -1.0 : 1.0;
  return view.seen_from(p.middle - EyeBelow::kBehind * p.towards(0.0) +
                        side * distance * kSize * p.normal(0.0));
}

Case eye_at_light(std::uint64_t seed, double distance) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  const double around = stage.random.between(0.0, 6.28);
  const glm::dvec3 out{std::cos(around), 0.0, std::sin(around)};
  functional::Camera& camera = stage.camera();
  camera.target = below(stage.light(), stage.aim, kSize);
  camera.eye = stage.light().centre + distance * kSize * out;
  camera.up = -out;
  camera.field_of_view_degrees = 30.0;
  return std::move(stage.result);
}

// The camera looks straight down past the plate. From ratio 1 on the near plane cuts the volumes.
Case near_crossing(std::uint64_t seed, double ratio) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  constexpr double kAbovePlate = 4.0;
  const double around = stage.random.between(0.0, 6.28);
  functional::Camera& camera = stage.camera();
  const glm::dvec3 shadow = below(stage.light(), stage.aim, kSize);
  camera.target = shadow;
  camera.eye = {shadow.x, kSize - kDepth + kAbovePlate, shadow.z};
  camera.up = {std::cos(around), 0.0, std::sin(around)};
  camera.near_plane = ratio * kAbovePlate;
  return std::move(stage.result);
}

// The eye moves below the plate through its shadow, looking ahead. Another plate's shadow is ahead
// of it all the way.
Case behind_eye(std::uint64_t seed, double share) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  constexpr double kWay = 5.0;
  constexpr double kAhead = 9.5;
  const double around = stage.random.between(0.0, 6.28);
  const glm::dvec3 ahead{std::cos(around), 0.0, std::sin(around)};
  const glm::dvec3 middle = below(stage.light(), stage.aim, kSize);
  stage.aim += (kAhead / kSize) * Slope(ahead.x, ahead.z);
  add_plate(stage);
  functional::Camera& camera = stage.camera();
  camera.eye = middle + glm::dvec3(0.0, 1.5, 0.0) + (2.0 * share - 1.0) * kWay * ahead;
  camera.target = camera.eye + ahead - glm::dvec3(0.0, 0.5, 0.0);
  camera.near_plane = 0.05;
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> eye_families() {
  const std::vector<double> to_plane = decades(-2, -10, {0.0});
  return {
      {"eye-in-wedge",
       "distance of the eye, inside a wedge, from its outer side over the light's "
       "height",
       "",
       to_plane,
       {0.0, 0.0},
       eye_in_wedge},
      {"eye-in-umbra",
       "distance of the eye, inside an umbra, from the penumbra over the light's "
       "height",
       "",
       to_plane,
       {0.0, 0.0},
       eye_in_umbra},
      {"eye-on-plane",
       "distance of the eye from the plane of a shadow quad over the light's height",
       "",
       to_plane,
       {0.0, 0.0},
       eye_on_plane},
      {"eye-at-light",
       "distance of the eye from the light's centre over the light's height",
       "",
       decades(0, -9, {0.0}),
       {0.0, 0.0},
       eye_at_light},
      {"near-crossing",
       "distance of the near plane over that of the nearest silhouette edges",
       "",
       {0.5, 0.9, 0.99, 0.999, 0.999999, 1.0, 1.000001, 1.001, 1.01, 1.1, 1.3, 1.5, 1.7},
       {1.7, 1.7},
       near_crossing},
      {"behind-eye",
       "way of the eye through the volumes: 0 before them, 1 past them",
       "",
       {0.0, 0.1, 0.2, 0.3, 0.4, 0.5, 0.6, 0.7, 0.8, 0.9, 1.0},
       {1.0, 1.0},
       behind_eye},
  };
}

}  // namespace wedgesim::reports::stress
