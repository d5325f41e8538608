#include "functional/methods/light_depths.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>
#include <limits>

#include "functional/raster/light_map.h"

namespace wedgesim::functional {
namespace {

constexpr float kInfinity = std::numeric_limits<float>::infinity();
// Of the depth: the most that a texel's depth is pushed back by its triangle's slope. A triangle
// that steep is lit at grazing incidence alone.
constexpr double kMostOffset = 0.02;

using Triangles = std::vector<std::array<glm::dvec3, 3>>;

void append(const Mesh& mesh, Triangles& triangles) {
  for (const auto& corner : mesh.triangles) {
    triangles.push_back(
        {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]});
  }
}

}  // namespace

ShadowMaps draw_shadow_maps(const Scene& scene, const Window& light_window) {
  Triangles triangles;
  for (const Object& object : scene.objects) {
    if (object.casts) append(object.mesh, triangles);
  }
  const std::size_t casting = triangles.size();
  for (const Object& object : scene.objects) {
    if (!object.casts) append(object.mesh, triangles);
  }

  const auto size = static_cast<std::size_t>(light_window.width);
  ShadowMaps maps;
  maps.surfaces = {light_window.width, std::vector<float>(size * size, kInfinity)};
  maps.casters = maps.surfaces;
  std::vector<std::uint64_t> compared(size, 0);
  const MapTriangles drawn(light_window, triangles);
  drawn.for_each_row([&](const MapTriangle& triangle, int y, int x_begin, int x_end) {
    float* surfaces = maps.surfaces.values.data() + static_cast<std::size_t>(y) * size;
    float* casters = maps.casters.values.data() + static_cast<std::size_t>(y) * size;
    const bool casts = triangle.index < casting;
    const double slope = std::abs(triangle.inverse_w.a) + std::abs(triangle.inverse_w.b);
    for (int x = x_begin; x < x_end; ++x) {
      const double z = triangle.w(x + 0.5, y + 0.5);
      surfaces[x] = std::min(surfaces[x], static_cast<float>(z));
      if (!casts) continue;
      const double farthest = 1.0 / std::max(1.0 / z - slope, 1.0 / (z * (1.0 + kMostOffset)));
      casters[x] = std::min(casters[x], static_cast<float>(farthest));
    }
    compared[static_cast<std::size_t>(y)] += static_cast<std::uint64_t>(x_end - x_begin);
  });
  for (const std::uint64_t row : compared) maps.compared += row;
  return maps;
}

}  // namespace wedgesim::functional
