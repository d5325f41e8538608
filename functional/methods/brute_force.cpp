#include "functional/methods/brute_force.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "functional/geometry/segment.h"
#include "functional/light/coverage.h"
#include "functional/methods/light_intensity.h"

namespace wedgesim::functional {
namespace {

// \param blur  how far the point may be from its surface, world units: a light-facing triangle this
//              near is the surface the point lies on and does not hide it
double coverage_intensity(const Scene& scene, const ShadowGeometry& geometry, const glm::dvec3& p,
                          double blur, const glm::dvec3& in_light) {
  double li = 1.0;
  for (const auto& cap : geometry.caps) {
    if (!segment_triangle(p, scene.light.centre, cap[0], cap[1], cap[2])) continue;
    const glm::dvec3 normal = glm::normalize(glm::cross(cap[1] - cap[0], cap[2] - cap[0]));
    if (std::abs(glm::dot(normal, p - cap[0])) > blur) li -= 1.0;
  }
  for (const ShadowWedge& wedge : geometry.wedges) {
    const double covered =
        coverage(scene.light.shape, in_light, wedge.light_begin, wedge.light_end);
    li += wedge.umbra_plane.inside(p) ? covered : -covered;
  }
  return li;
}

double linear_intensity_of_all(const Scene& scene, const Window& window,
                               const ShadowGeometry& geometry, const glm::dvec3& p,
                               const glm::dvec3& in_light) {
  double li = 1.0;
  for (const ShadowWedge& wedge : geometry.wedges) {
    for (const std::size_t i : {1U, 2U}) {
      const auto& [a, b, c] = std::array{wedge.umbra[0], wedge.umbra[i], wedge.umbra[i + 1]};
      if (!segment_triangle(window.eye, p, a, b, c)) continue;
      li += glm::dot(glm::cross(b - a, c - a), window.eye - a) > 0.0 ? -1.0 : 1.0;
    }
    const bool inside = std::all_of(wedge.planes.begin(), wedge.planes.end(),
                                    [&](const SidedPlane& plane) { return plane.inside(p); });
    if (inside) {
      li += penumbra_share(scene.light, traces::fb::WedgeKind_linear, wedge, p, in_light, true);
    }
  }
  return li;
}

}  // namespace

std::vector<double> brute_force_light_intensity(const Scene& scene, const Window& window,
                                                const DepthBuffer& depth,
                                                const ShadowGeometry& geometry,
                                                std::span<const std::size_t> pixels) {
  std::vector<double> result(pixels.size(), 1.0);
  const glm::dmat4 to_light = light_from_world(scene.light);
  const auto width = static_cast<std::size_t>(window.width);
  tbb::parallel_for(std::size_t{0}, pixels.size(), [&](std::size_t i) {
    const std::size_t pixel = pixels[i];
    if (depth.triangle[pixel] == DepthBuffer::kSky) return;
    const double z = traces::decode_depth(depth.format, depth.words[pixel]);
    const double x = static_cast<double>(pixel % width) + 0.5;
    const double y = static_cast<double>(pixel / width) + 0.5;
    const glm::dvec3 p = world_point(window, x, y, z);
    const glm::dvec3 in_light(to_light * glm::dvec4(p, 1.0));
    if (geometry.kind == traces::fb::WedgeKind_linear) {
      result[i] = linear_intensity_of_all(scene, window, geometry, p, in_light);
      return;
    }
    double blur = 0.0;
    if (scene.objects[depth.surface(pixel).object].casts) {
      const double farther_z = traces::decode_depth(
          depth.format, traces::step_depth(depth.format, depth.words[pixel], 1));
      blur = glm::distance(p, world_point(window, x, y, farther_z));
    }
    result[i] = coverage_intensity(scene, geometry, p, blur, in_light);
  });
  return result;
}

}  // namespace wedgesim::functional
