#include <cmath>
#include <glm/geometric.hpp>
#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

constexpr double kNearer = 3.0;  // depths of the ends of edges along the light's direction
constexpr double kFarther = 5.0;

// Where edges run along the light's direction, linear wedges are sensible only of lights that the
// edges' lines miss at the harmless end.
Stage stage_for_towers(std::uint64_t seed) {
  return make_stage(seed, variant_of(seed) == Variant::linear ? 0.3 : kLightRadius);
}

double length_of(const Slope& slope) { return std::sqrt(1.0 + glm::dot(slope, slope)); }

double any_turn(Stage& stage) { return stage.random.between(0.0, 1.5); }

// Across the slope from the middle, in the direction of the loop.
Slope along_loop(const Slope& middle, const Slope& corner) {
  const Slope out = glm::normalize(corner - middle);
  return {-out.y, out.x};
}

// Four corners, each an edge from nearer to the light to farther from it, whose ends differ in
// slope by `apart`.
void add_towers(Stage& stage, double apart) {
  std::vector<glm::dvec3> loop;
  for (const Slope& corner : ring(stage.aim, kAcross, 4, any_turn(stage))) {
    const Slope slope = on_grid(corner);
    loop.push_back(below(stage.light(), slope, kNearer));
    loop.push_back(below(stage.light(), slope + apart * along_loop(stage.aim, slope), kFarther));
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
}

// How far apart the ends of an edge from kNearer to kFarther are in slope, if the edge makes an
// angle with the line from the light's centre to its middle.
double apart_for_angle(double angle, const Slope& slope) {
  return std::tan(angle) * length_of(slope) * (kFarther * kFarther - kNearer * kNearer) /
         (2.0 * kNearer * kFarther);
}

Case grazing_edge(std::uint64_t seed, double angle) {
  Stage stage = stage_for_towers(seed);
  add_towers(stage, apart_for_angle(angle, stage.aim));
  return std::move(stage.result);
}

Case edge_at_light(std::uint64_t seed, double radii) {
  Stage stage = stage_for_towers(seed);
  // |P x Q| = distance · |Q - P|, with P and Q at the two depths and almost across the slope.
  const double distance = radii * radius_of(stage.light());
  const double slope = length_of(stage.aim);
  const double product = kNearer * kFarther * slope;
  add_towers(stage, distance * (kFarther - kNearer) * slope /
                        std::sqrt(product * product - distance * distance * kFarther * kFarther));
  return std::move(stage.result);
}

Case collinear_edges(std::uint64_t seed, double deviation) {
  Stage stage = make_stage(seed, kLightRadius);
  const std::vector<Slope> corners = ring(stage.aim, kAcross, 4, any_turn(stage));
  // The middle of each side is moved out, in, or towards the light: across the side in any case.
  const double way = stage.random.between(0.0, 6.28);
  std::vector<glm::dvec3> loop;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 begin = below(stage.light(), corners[i], kDepth);
    const glm::dvec3 end = below(stage.light(), corners[(i + 1) % corners.size()], kDepth);
    const glm::dvec3 up(0.0, 1.0, 0.0);
    const glm::dvec3 out = glm::normalize(glm::cross(up, end - begin));
    const double off = 0.5 * glm::distance(begin, end) * std::tan(0.5 * deviation);
    loop.push_back(begin);
    loop.push_back(0.5 * (begin + end) + off * (std::cos(way) * out + std::sin(way) * up));
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

Case acute_corner(std::uint64_t seed, double angle) {
  Stage stage = make_stage(seed, kLightRadius);
  const double turn = any_turn(stage);
  const Slope x{std::cos(turn), std::sin(turn)};
  const Slope z{-x.y, x.x};
  constexpr double kSpike = 0.28;
  constexpr double kWaist = 0.12;
  const double half = kSpike * std::tan(0.5 * angle);
  std::vector<glm::dvec3> loop;
  for (const double side : {1.0, -1.0}) {
    for (const Slope& p :
         {Slope{kWaist, -half}, {kWaist + kSpike, 0.0}, {kWaist, half}, {0.0, 0.25}}) {
      loop.push_back(below(stage.light(), stage.aim + side * (p.x * x + p.y * z), kDepth));
    }
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

Case zigzag(std::uint64_t seed, double angle) {
  Stage stage = stage_for_towers(seed);
  std::vector<Slope> corners = ring(stage.aim, kAcross, 4, any_turn(stage));
  std::vector<glm::dvec3> loop;
  for (std::size_t i = 0; i < 3; ++i) loop.push_back(below(stage.light(), corners[i], 4.0));
  const Slope last = on_grid(corners[3]);
  const Slope tooth = apart_for_angle(angle, last) * along_loop(stage.aim, last);
  constexpr int kTeeth = 3;
  for (int i = -kTeeth; i <= kTeeth; ++i) {
    loop.push_back(below(stage.light(), last + static_cast<double>(i) * tooth,
                         i % 2 == 0 ? kNearer : kFarther));
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

Case distance_ratio(std::uint64_t seed, double ratio) {
  // The light stays clear of the nearer ends: it shrinks with their distance.
  Stage stage = make_stage(seed, kLightRadius / ratio);
  std::vector<glm::dvec3> loop;
  for (const Slope& slope : ring(stage.aim, kAcross, 4, any_turn(stage))) {
    loop.push_back(below(stage.light(), slope, loop.size() % 2 == 0 ? kDepth : kDepth / ratio));
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

// At length 0 the ends of the short edges are two vertices at one place. Triangles at such an edge
// have no area and face nothing, so that the silhouette runs round them.
Case short_edge(std::uint64_t seed, double length) {
  Stage stage = make_stage(seed, kLightRadius);
  std::vector<glm::dvec3> loop;
  for (const Slope& slope : ring(stage.aim, kAcross, 4, any_turn(stage))) {
    const Slope along = along_loop(stage.aim, slope);
    const glm::dvec3 corner = below(stage.light(), slope, kDepth);
    const glm::dvec3 half = 0.5 * length * kSize * glm::dvec3(along.x, 0.0, along.y);
    loop.push_back(corner - half);
    loop.push_back(corner + half);
  }
  add_caster(stage.result, between_pyramids(stage.light(), stage.aim, loop));
  return std::move(stage.result);
}

}  // namespace

std::vector<Family> edge_families() {
  const Family::Required angles{1e-3, 1e-6};
  return {
      {"grazing-edge", "angle of silhouette edges to the light's direction", "rad",
       decades(-1, -12, {0.0}), angles, grazing_edge},
      {"edge-at-light",
       "distance of an edge's line from the light's centre, in light radii",
       "",
       [] {
         std::vector<double> levels{2.0, 1.0, 0.5};
         const std::vector<double> nearer = decades(-1, -8, {0.0});
         levels.insert(levels.end(), nearer.begin(), nearer.end());
         return levels;
       }(),
       {0.0, 0.0},
       edge_at_light},
      {"collinear-edges", "angle of neighbouring edges to collinear", "rad",
       decades(-1, -12, {0.0}), angles, collinear_edges},
      {"acute-corner", "angle between neighbouring edges", "rad", decades(0, -12), angles,
       acute_corner},
      {"zigzag", "angle of a zigzag's edges to the light's direction", "rad", decades(-1, -12),
       angles, zigzag},
      {"distance-ratio",
       "ratio of the distances of an edge's ends to the light",
       "",
       decades(0, 11),
       {1e3, 1e6},
       distance_ratio},
      {"short-edge",
       "length of an edge over the light's height",
       "",
       decades(-1, -12, {0.0}),
       {1e-4, 1e-6},
       short_edge},
  };
}

}  // namespace wedgesim::reports::stress
