#include <cmath>
#include <map>

#include "tests/reports/stress/measured.h"
#include "tests/reports/stress/silhouettes.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Light;
using functional::LightShape;

double angle_between(const glm::dvec3& a, const glm::dvec3& b) {
  return std::atan2(glm::length(glm::cross(a, b)), glm::dot(a, b));
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

double width_of_light(const Case& made) {
  return glm::length(made.scene.light.half_v) / glm::length(made.scene.light.half_u);
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
  const auto loop = first_loop(made);
  for (const Edge& edge : loop) middle += edge.begin / static_cast<double>(loop.size());
  for (const Edge& edge : loop) farthest = std::max(farthest, glm::distance(edge.begin, middle));
  return radius_of(made.scene.light) / farthest;
}

double gap_to_light(const Case& made) {
  const Light& light = made.scene.light;
  double highest = -1e300;
  for (const glm::dvec3& p : caster(made).positions) highest = std::max(highest, p.y);
  const double bottom = light.centre.y - (light.shape == LightShape::sphere ? light.radius : 0.0);
  return (bottom - highest) / radius_of(light);
}

const std::vector<glm::dvec3>& floor(const Case& made) {
  return made.scene.objects[0].mesh.positions;
}

double floor_from_origin(const Case& made) {
  return glm::length(0.5 * (floor(made).front() + floor(made).back())) / kLightHeight;
}

double floor_scale(const Case& made) {
  return glm::length(floor(made)[1] - floor(made)[0]) / (3.0 * kLightHeight);
}

double silhouette_edges(const Case& made) { return static_cast<double>(first_loop(made).size()); }

double highest_degree(const Case& made) {
  std::map<std::uint32_t, int> ends;
  for (const auto& loop :
       functional::find_silhouette(caster(made), made.scene.light.centre).loops) {
    for (const auto& e : loop) {
      ++ends[e.begin];
      ++ends[e.end];
    }
  }
  int highest = 0;
  for (const auto& [vertex, degree] : ends) highest = std::max(highest, degree);
  return highest;
}

}  // namespace

std::map<std::string_view, Measure> caster_measures() {
  return {
      {"grazing-edge", to_line_of_light},    {"edge-at-light", line_from_light},
      {"collinear-edges", turn_at_corners},  {"acute-corner", corner_angle},
      {"zigzag", to_line_of_light},          {"distance-ratio", ratio_of_distances},
      {"short-edge", edge_length},           {"small-light", light_against_occluder},
      {"line-light", width_of_light},        {"large-light", light_against_occluder},
      {"touching-light", gap_to_light},      {"enclosing-light", gap_to_light},
      {"offset", floor_from_origin},         {"scale-up", floor_scale},
      {"scale-down", floor_scale},           {"many-edges", silhouette_edges},
      {"many-edges-wide", silhouette_edges}, {"vertex-degree", highest_degree},
  };
}

}  // namespace wedgesim::reports::stress
