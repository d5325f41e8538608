#include "tests/reports/stress/measured.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/geometry/segment.h"
#include "functional/geometry/silhouette.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"

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

std::vector<Edge> first_loop(const Case& made) { return loops(made).at(0); }

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

// The farthest of the points seen in the middle row from the nearest silhouette edge.
double row_from_edge(const Case& made) {
  const functional::Scene& scene = made.scene;
  const functional::Window window =
      functional::make_window(scene.camera, scene.width, scene.height);
  const functional::DepthBuffer depth =
      functional::render_depth(window, scene.objects, made.options.depth_format);
  const functional::Mesh& shelf = scene.objects.back().mesh;
  const functional::Silhouette silhouette = functional::find_silhouette(shelf, scene.light.centre);
  const auto width = static_cast<std::size_t>(scene.width);
  double farthest = 0.0;
  for (std::size_t x = width / 2 - 4; x <= width / 2 + 4; ++x) {
    const std::size_t i = static_cast<std::size_t>(scene.height / 2) * width + x;
    const glm::dvec3 p =
        functional::world_point(window, static_cast<double>(x) + 0.5, 0.5 * scene.height,
                                traces::decode_depth(depth.format, depth.words[i]));
    double nearest = 1e300;
    for (const auto& e : silhouette.loops[0]) {
      const glm::dvec3 a = shelf.positions[e.begin];
      const glm::dvec3 along = shelf.positions[e.end] - a;
      const double t = std::clamp(glm::dot(p - a, along) / glm::dot(along, along), 0.0, 1.0);
      nearest = std::min(nearest, glm::distance(p, a + t * along));
    }
    farthest = std::max(farthest, nearest);
  }
  return farthest / kLightHeight;
}

// Of the points that are not where the scene has them: the middle of their distances from the plane
// of the nearest shadow quad, in steps of stored z.
double steps_from_quads(const Case& made) {
  functional::FrameOptions options = made.options;
  options.expected_li = false;
  const functional::Frame frame = functional::make_frame(made.scene, options);
  const auto width = static_cast<std::size_t>(made.scene.width);
  std::vector<double> distances;
  for (std::size_t i = 0; i < made.depth->words.size(); ++i) {
    if (made.depth->words[i] == frame.depth.words[i]) continue;
    const double x = static_cast<double>(i % width) + 0.5;
    const double y = static_cast<double>(i / width) + 0.5;
    double nearest = 1e300;
    for (const auto& wedge : frame.trace.wedges) {
      const auto& plane = frame.trace.planes[wedge.umbra_plane() / 2];
      const double z = -((plane.a() * x + plane.b() * y) + plane.d()) / plane.c();
      nearest = std::min(nearest, std::abs(z * 16777215.0 - made.depth->words[i]));
    }
    distances.push_back(nearest);
  }
  if (10 * distances.size() < made.depth->words.size()) return 1e300;
  std::ranges::sort(distances);
  return std::round(distances[distances.size() / 2]);
}

double depth_ratio(const Case& made) {
  return made.scene.camera.far_plane / made.scene.camera.near_plane;
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

// The eye's distance from the nearest plane of a shadow quad.
double eye_from_quad(const Case& made) {
  const functional::Scene& scene = made.scene;
  return least_of_edges(made,
                        [&](const Edge& edge) {
                          const glm::dvec3 normal = glm::normalize(glm::cross(
                              edge.begin - scene.light.centre, edge.end - scene.light.centre));
                          return std::abs(glm::dot(normal, scene.camera.eye - edge.begin));
                        }) /
         kLightHeight;
}

// The eye's distance from the nearest outer or inner bound of a penumbra: a plane through an edge
// that touches the light.
double eye_from_bound(const Case& made) {
  const functional::Scene& scene = made.scene;
  const Light& light = scene.light;
  double least = 1e300;
  for (const Edge& edge : first_loop(made)) {
    const glm::dvec3 along = glm::normalize(edge.end - edge.begin);
    const auto keep_nearer = [&](const glm::dvec3& normal) {
      least = std::min(least, std::abs(glm::dot(normal, scene.camera.eye - edge.begin)));
    };
    if (light.shape == LightShape::rectangle) {
      const auto corners = functional::light_corners(light);
      for (const glm::dvec3& corner : corners) {
        const glm::dvec3 n = glm::normalize(glm::cross(along, corner - edge.begin));
        double low = 0.0;
        double high = 0.0;
        for (const glm::dvec3& other : corners) {
          low = std::min(low, glm::dot(n, other - edge.begin));
          high = std::max(high, glm::dot(n, other - edge.begin));
        }
        if (low > -1e-9 || high < 1e-9) keep_nearer(n);
      }
    } else {
      const glm::dvec3 to_light = light.centre - edge.begin;
      const glm::dvec3 a = to_light - glm::dot(to_light, along) * along;
      const glm::dvec3 u = glm::normalize(a);
      const glm::dvec3 v = glm::cross(along, u);
      const double sine = light.radius / glm::length(a);
      for (const double side : {-1.0, 1.0})
        keep_nearer(std::sqrt(1.0 - sine * sine) * v + side * sine * u);
    }
  }
  return least / kLightHeight;
}

double eye_from_light(const Case& made) {
  return glm::distance(made.scene.camera.eye, made.scene.light.centre) / kLightHeight;
}

double near_against_edges(const Case& made) {
  double highest = -1e300;
  for (const Edge& edge : first_loop(made)) highest = std::max(highest, edge.begin.y);
  return made.scene.camera.near_plane / (made.scene.camera.eye.y - highest);
}

// How many casters the rays from the light's centre to the floor round their shadow's middle meet.
double casters_over_shadow(const Case& made) {
  const functional::Scene& scene = made.scene;
  double count = 0.0;
  for (const functional::Object& object : scene.objects) {
    if (!object.casts) continue;
    const auto silhouette = functional::find_silhouette(object.mesh, scene.light.centre);
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
      if (!silhouette.light_facing[t]) continue;
      const auto& c = object.mesh.triangles[t];
      // Off the middle, where the triangles meet.
      const glm::dvec3 at = scene.camera.target + glm::dvec3(0.1, 0.0, 0.07);
      count +=
          functional::segment_triangle(at, scene.light.centre, object.mesh.positions[c[0]],
                                       object.mesh.positions[c[1]], object.mesh.positions[c[2]])
              ? 1.0
              : 0.0;
    }
  }
  return count;
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

// Of all corners of the silhouette from the pixel centres' rows and columns, 1/256 pixel.
double corners_from_centres(const Case& made) {
  const functional::Window window =
      functional::make_window(made.scene.camera, made.scene.width, made.scene.height);
  double most = 0.0;
  for (const Edge& edge : first_loop(made)) {
    const glm::dvec4 p = window.window_from_world * glm::dvec4(edge.begin, 1.0);
    for (const double at : {p.x / p.w, p.y / p.w}) {
      most = std::max(most, std::abs(at - std::floor(at) - 0.5) * 256.0);
    }
  }
  return most;
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
      {"touching-light", gap_to_light},
      {"contact", row_from_edge},
      {"on-quad-plane", steps_from_quads},
      {"near-far-unorm16", depth_ratio},
      {"near-far-unorm24", depth_ratio},
      {"near-far-float32", depth_ratio},
      {"near-far-reversed", depth_ratio},
      {"offset", floor_from_origin},
      {"scale-up", floor_scale},
      {"scale-down", floor_scale},
      {"eye-in-wedge", eye_from_bound},
      {"eye-in-umbra", eye_from_bound},
      {"eye-on-plane", eye_from_quad},
      {"eye-at-light", eye_from_light},
      {"near-crossing", near_against_edges},
      {"overlap", casters_over_shadow},
      {"many-edges", silhouette_edges},
      {"many-edges-wide", silhouette_edges},
      {"vertex-degree", highest_degree},
      {"pixel-on-edge", corners_from_centres},
  };
  const auto found = kMeasures.find(family);
  return found == kMeasures.end() ? nullptr : found->second;
}

}  // namespace wedgesim::reports::stress
