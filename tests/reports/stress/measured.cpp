#include "tests/reports/stress/measured.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "functional/geometry/silhouette.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Light;
using functional::LightShape;

constexpr double kLightHeight = 8.0;

struct Edge {
  glm::dvec3 begin, end;
};

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
}

double radius_of(const Light& light) {
  return light.shape == LightShape::rectangle ? glm::length(light.half_u) : light.radius;
}

const functional::Mesh& caster(const Case& made) { return made.scene.objects[1].mesh; }

/// The loops of the first caster's silhouette. Vertices, not positions: edges of no length count.
std::vector<std::vector<Edge>> loops(const Case& made) {
  const functional::Mesh& mesh = caster(made);
  std::vector<std::vector<Edge>> result;
  for (const auto& loop : functional::find_silhouette(mesh, made.scene.light.centre).loops) {
    auto& edges = result.emplace_back();
    for (const auto& e : loop) edges.push_back({mesh.positions[e.begin], mesh.positions[e.end]});
  }
  return result;
}

template <typename Value>
double least_of_edges(const Case& made, Value value) {
  double least = 1e300;
  for (const auto& loop : loops(made)) {
    for (const Edge& edge : loop) least = std::min(least, value(edge));
  }
  return least;
}

template <typename Value>
double least_of_corners(const Case& made, Value value) {
  double least = 1e300;
  for (const auto& loop : loops(made)) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      const Edge& next = loop[(i + 1) % loop.size()];
      least = std::min(least, value(loop[i].end - loop[i].begin, next.end - next.begin));
    }
  }
  return least;
}

double to_line_of_light(const Case& made) {
  return least_of_edges(made, [&](const Edge& edge) {
    const glm::dvec3 along = edge.end - edge.begin;
    const double angle =
        angle_between(along, 0.5 * (edge.begin + edge.end) - made.scene.light.centre);
    return std::min(angle, M_PI - angle);
  });
}

// Of every edge between two vertices of the mesh's loop, whether it is in the silhouette or not.
double line_from_light(const Case& made) {
  const Light& light = made.scene.light;
  const functional::Mesh& mesh = caster(made);
  double least = 1e300;
  for (std::size_t i = 0; i + 3 < mesh.positions.size(); ++i) {
    const glm::dvec3 p = mesh.positions[i] - light.centre;
    const glm::dvec3 q = mesh.positions[i + 1] - light.centre;
    least = std::min(least, glm::length(glm::cross(p, q)) / glm::length(q - p));
  }
  return least / radius_of(light);
}

double turn_at_corners(const Case& made) { return least_of_corners(made, angle_between); }

double corner_angle(const Case& made) {
  return least_of_corners(
      made, [](const glm::dvec3& a, const glm::dvec3& b) { return angle_between(-a, b); });
}

double ratio_of_distances(const Case& made) {
  return 1.0 / least_of_edges(made, [&](const Edge& edge) {
           const double a = glm::distance(edge.begin, made.scene.light.centre);
           const double b = glm::distance(edge.end, made.scene.light.centre);
           return std::min(a, b) / std::max(a, b);
         });
}

double edge_length(const Case& made) {
  const functional::Mesh& mesh = caster(made);
  double least = 1e300;
  for (const auto& t : mesh.triangles) {
    for (std::size_t i = 0; i < 3; ++i) {
      least = std::min(least, glm::distance(mesh.positions[t[i]], mesh.positions[t[(i + 1) % 3]]));
    }
  }
  return least / kLightHeight;
}

double light_against_occluder(const Case& made) {
  glm::dvec3 middle(0.0);
  double farthest = 0.0;
  const auto all = loops(made);
  for (const Edge& edge : all[0]) middle += edge.begin / static_cast<double>(all[0].size());
  for (const Edge& edge : all[0]) farthest = std::max(farthest, glm::distance(edge.begin, middle));
  return radius_of(made.scene.light) / farthest;
}

}  // namespace

Measure measure_of(std::string_view family) {
  static const std::map<std::string_view, Measure> kMeasures{
      {"grazing-edge", to_line_of_light},
      {"edge-at-light", line_from_light},
      {"collinear-edges", turn_at_corners},
      {"acute-corner", corner_angle},
      {"zigzag", to_line_of_light},
      {"distance-ratio", ratio_of_distances},
      {"short-edge", edge_length},
      {"small-light", light_against_occluder},
      {"large-light", light_against_occluder},
  };
  const auto found = kMeasures.find(family);
  return found == kMeasures.end() ? nullptr : found->second;
}

}  // namespace wedgesim::reports::stress
