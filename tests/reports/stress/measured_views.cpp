#include <cmath>

#include "functional/geometry/extent.h"
#include "functional/geometry/segment.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "tests/reports/stress/measured.h"
#include "tests/reports/stress/silhouettes.h"

namespace wedgesim::reports::stress {
namespace {

using functional::Light;
using functional::LightShape;

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

std::map<std::string_view, Measure> view_measures() {
  return {
      {"contact", row_from_edge},
      {"on-quad-plane", steps_from_quads},
      {"near-far-unorm16", depth_ratio},
      {"near-far-unorm24", depth_ratio},
      {"near-far-float32", depth_ratio},
      {"near-far-reversed", depth_ratio},
      {"eye-in-wedge", eye_from_bound},
      {"eye-in-umbra", eye_from_bound},
      {"eye-on-plane", eye_from_quad},
      {"eye-at-light", eye_from_light},
      {"near-crossing", near_against_edges},
      {"overlap", casters_over_shadow},
      {"pixel-on-edge", corners_from_centres},
  };
}

}  // namespace wedgesim::reports::stress
