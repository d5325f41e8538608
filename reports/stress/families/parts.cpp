#include "reports/stress/families/parts.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>
#include <utility>

#include "base/check.h"
#include "functional/scene/primitives.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Light;
using functional::LightShape;

// The two pyramids reach this much nearer to the light than the loop and farther from it.
constexpr double kThickness = 0.05;

double grid(double value, double step) { return std::round(value / step) * step; }

Light make_light(Variant variant, double radius, const glm::dvec3& centre, Random& random) {
  const double roll = random.between(-0.3, 0.3);
  const double aspect = random.between(0.7, 1.0);
  const glm::dvec3 down =
      glm::normalize(glm::dvec3{random.between(-0.05, 0.05), -1.0, random.between(-0.05, 0.05)});
  const glm::dvec3 u =
      glm::normalize(glm::cross(glm::dvec3(-std::sin(roll), 0.0, std::cos(roll)), down));
  Light light;
  light.centre = centre;
  light.shape = variant == Variant::sphere ? LightShape::sphere : LightShape::rectangle;
  light.half_u = u;
  light.half_v = aspect * glm::cross(down, u);
  light.radius = 1.0;
  resize(light, radius);
  return light;
}

}  // namespace

Stage make_stage(std::uint64_t seed, double light_radius) {
  Stage stage{{}, Random(seed), {}};
  functional::Scene& scene = stage.result.scene;
  scene.name = "stress";
  scene.place = "stress";
  scene.width = 32;
  scene.height = 24;
  functional::Mesh floor = functional::make_plane({kFloorSide, kFloorSide}, {1, 1});
  floor.name = "floor";
  scene.objects.push_back({std::move(floor)});

  Random& random = stage.random;
  const glm::dvec3 centre{grid(random.between(-1.0, 1.0), 0.015625), kSize,
                          grid(random.between(-1.0, 1.0), 0.015625)};
  scene.light = make_light(variant_of(seed), light_radius, centre, random);
  stage.result.options.kind = variant_of(seed) == Variant::linear ? traces::fb::WedgeKind_linear
                                                                  : traces::fb::WedgeKind_coverage;
  // The shadow is near the origin, and the camera looks at it below the casters.
  const glm::dvec2 shadow{random.between(-0.3, 0.3), random.between(-0.3, 0.3)};
  stage.aim = (shadow - glm::dvec2(centre.x, centre.z)) / kSize;
  const double around = random.between(-0.4, 0.4);
  scene.camera.target = {shadow.x, 0.0, shadow.y};
  scene.camera.eye =
      scene.camera.target +
      glm::dvec3(6.0 * std::sin(around), random.between(4.0, 4.4), 6.0 * std::cos(around));
  scene.camera.field_of_view_degrees = 36.0;
  scene.camera.near_plane = 1.0;
  scene.camera.far_plane = 40.0;
  return stage;
}

double radius_of(const Light& light) {
  return light.shape == LightShape::rectangle
             ? std::max(glm::length(light.half_u), glm::length(light.half_v))
             : light.radius;
}

void resize(Light& light, double radius) {
  if (radius == 0.0) {
    light.shape = LightShape::point;
    light.half_u = light.half_v = glm::dvec3(0.0);
    light.radius = 0.0;
    return;
  }
  const double scale = radius / radius_of(light);
  if (light.shape == LightShape::rectangle) {
    light.half_u *= scale;
    light.half_v *= scale;
    light.radius = 0.0;
  } else {
    light.half_u = light.half_v = glm::dvec3(0.0);
    light.radius = radius;
  }
}

glm::dvec3 below(const Light& light, const Slope& slope, double depth) {
  return light.centre + depth * glm::dvec3(slope.x, -1.0, slope.y);
}

std::vector<glm::dvec3> below(const Light& light, const std::vector<Slope>& slopes, double depth) {
  std::vector<glm::dvec3> points;
  points.reserve(slopes.size());
  for (const Slope& slope : slopes) points.push_back(below(light, slope, depth));
  return points;
}

Slope on_grid(const Slope& slope) {
  return {grid(slope.x, 1.0 / 1024.0), grid(slope.y, 1.0 / 1024.0)};
}

std::vector<Slope> ring(const Slope& middle, double radius, int corners, double turn) {
  std::vector<Slope> slopes;
  for (int i = 0; i < corners; ++i) {
    const double angle = turn + glm::two_pi<double>() * i / corners;
    slopes.push_back(middle + radius * glm::dvec2(std::cos(angle), std::sin(angle)));
  }
  return slopes;
}

functional::Mesh between_pyramids(const Light& light, const Slope& middle,
                                  const std::vector<glm::dvec3>& loop) {
  CHECK_GE(loop.size(), 3U);
  const auto [high, low] = std::ranges::minmax_element(
      loop, [](const glm::dvec3& a, const glm::dvec3& b) { return a.y > b.y; });
  functional::Mesh mesh;
  mesh.positions = loop;
  const auto n = static_cast<std::uint32_t>(loop.size());
  mesh.positions.push_back(below(light, middle, (1.0 - kThickness) * (light.centre.y - high->y)));
  mesh.positions.push_back(below(light, middle, (1.0 + kThickness) * (light.centre.y - low->y)));
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    mesh.triangles.push_back({n, next, i});
    mesh.triangles.push_back({n + 1, i, next});
  }
  return mesh;
}

std::vector<glm::dvec3> add_plate(Stage& stage) {
  const double turn = stage.random.between(0.0, 1.5);
  std::vector<glm::dvec3> loop = below(stage.light(), ring(stage.aim, kAcross, 4, turn), kDepth);
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return loop;
}

void add_caster(Case& result, functional::Mesh mesh, const std::string& name) {
  mesh.name = name;
  functional::Object object;
  object.mesh = std::move(mesh);
  object.casts = true;
  result.scene.objects.push_back(std::move(object));
}

std::vector<double> decades(int first, int last) {
  // Literals, because a power that the library computes may be a neighbour of the nearest double.
  static constexpr std::array kPowers{1e-12, 1e-11, 1e-10, 1e-9, 1e-8, 1e-7, 1e-6, 1e-5, 1e-4,
                                      1e-3,  1e-2,  1e-1,  1e0,  1e1,  1e2,  1e3,  1e4,  1e5,
                                      1e6,   1e7,   1e8,   1e9,  1e10, 1e11, 1e12};
  constexpr int kZero = 12;  // the index of 10^0
  std::vector<double> powers;
  const int step = first <= last ? 1 : -1;
  for (int i = first; i != last + step; i += step) {
    const int index = i + kZero;
    powers.push_back(kPowers.at(static_cast<std::size_t>(index)));
  }
  return powers;
}

std::vector<double> decades(int first, int last, const std::vector<double>& then) {
  std::vector<double> levels = decades(first, last);
  levels.insert(levels.end(), then.begin(), then.end());
  return levels;
}

}  // namespace wedgesim::reports::stress
