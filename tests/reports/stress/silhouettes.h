#pragma once

#include <algorithm>
#include <glm/geometric.hpp>
#include <vector>

#include "functional/geometry/silhouette.h"
#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

inline constexpr double kLightHeight = 8.0;

struct Edge {
  glm::dvec3 begin, end;
};

inline double radius_of(const functional::Light& light) {
  return light.shape == functional::LightShape::rectangle ? glm::length(light.half_u)
                                                          : light.radius;
}

/// The first object after the floor, in most families the only caster.
inline const functional::Mesh& caster(const Case& made) { return made.scene.objects[1].mesh; }

/// The loops of its silhouette from the light's centre. Vertices, not positions: edges of no length
/// count.
inline std::vector<std::vector<Edge>> loops(const Case& made) {
  const functional::Mesh& mesh = caster(made);
  std::vector<std::vector<Edge>> result;
  for (const auto& loop : functional::find_silhouette(mesh, made.scene.light.centre).loops) {
    auto& edges = result.emplace_back();
    for (const auto& e : loop) edges.push_back({mesh.positions[e.begin], mesh.positions[e.end]});
  }
  return result;
}

inline std::vector<Edge> first_loop(const Case& made) { return loops(made).at(0); }

template <typename Value>
double least_of_edges(const Case& made, Value value) {
  double least = 1e300;
  for (const auto& loop : loops(made)) {
    for (const Edge& edge : loop) least = std::min(least, value(edge));
  }
  return least;
}

}  // namespace wedgesim::reports::stress
