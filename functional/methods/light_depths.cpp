#include "functional/methods/light_depths.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/vec3.hpp>

#include "functional/raster/light_map.h"
#include "functional/raster/spans.h"

namespace wedgesim::functional {
namespace {

constexpr float kFront = 0.25F;       // of the way from a caster's back to its front
constexpr double kMostSlope = 0.002;  // of the depth, over a texel: steeper is seen from aside
constexpr std::size_t kTrianglesATask = 2048;

// A triangle, or a convex part of a clipped one, in the light's image.
struct Drawn {
  std::array<SnappedPoint, 3> outline;
  float a = 0.0F, b = 0.0F, c = 0.0F;   // 1/z = a·x + b·y + c, texels
  float least = 0.0F, greatest = 0.0F;  // 1/z of its corners
  bool back = false;                    // of a caster, facing away from the light
};

void append(const std::array<glm::dvec3, 3>& corners, bool back, std::vector<Drawn>& result) {
  Drawn drawn;
  for (std::size_t i = 0; i < 3; ++i) {
    drawn.outline[i] = snap(WindowPoint(corners[i].x, corners[i].y, 0.0));
  }
  if (doubled_area(drawn.outline) == 0) return;
  const auto [least, greatest] = std::minmax({corners[0].z, corners[1].z, corners[2].z});
  const glm::dvec3 p = corners[1] - corners[0];
  const glm::dvec3 q = corners[2] - corners[0];
  const double area = p.x * q.y - p.y * q.x;
  const double a = area != 0.0 ? (p.z * q.y - p.y * q.z) / area : 0.0;
  const double b = area != 0.0 ? (p.x * q.z - p.z * q.x) / area : 0.0;
  // A back is as far as it is anywhere within a texel: a caster may be thinner than that.
  const double moved = back ? std::min(std::abs(a) + std::abs(b), kMostSlope * corners[0].z) : 0.0;
  drawn.a = static_cast<float>(a);
  drawn.b = static_cast<float>(b);
  drawn.c = static_cast<float>(corners[0].z - moved - a * corners[0].x - b * corners[0].y);
  drawn.least = static_cast<float>(least - moved);
  drawn.greatest = static_cast<float>(greatest - moved);
  drawn.back = back;
  result.push_back(drawn);
}

// Corners are texels and 1/z. What is not before the near plane and about the map is clipped.
void prepare(const Window& view, const std::array<glm::dvec3, 3>& triangle, bool back,
             double nearest, std::vector<Drawn>& result) {
  std::array<glm::dvec3, 3> corners;
  bool whole = true;
  for (std::size_t i = 0; i < 3; ++i) {
    const MapPlace place = place_in(view, triangle[i]);
    corners[i] = {place.x, place.y, 1.0 / place.w};
    whole = whole && place.w >= nearest && std::abs(place.x) < kGuardHigh / 2 &&
            std::abs(place.y) < kGuardHigh / 2 && place.x > kGuardLow && place.y > kGuardLow;
  }
  if (whole) {
    append(corners, back, result);
    return;
  }
  std::vector<WindowPoint> points = clip_to_window(view, triangle);
  for (WindowPoint& p : points) p.z = 1.0 / view_distance(view, p.z);
  for (std::size_t i = 2; i < points.size(); ++i) {
    append({points[0], points[i - 1], points[i]}, back, result);
  }
}

std::vector<Drawn> prepare_all(const Scene& scene, std::span<const Silhouette> silhouettes,
                               const Window& view) {
  struct Task {
    std::size_t object, begin, end;
  };
  std::vector<Task> tasks;
  for (std::size_t i = 0; i < scene.objects.size(); ++i) {
    const std::size_t triangles = scene.objects[i].mesh.triangles.size();
    for (std::size_t t = 0; t < triangles; t += kTrianglesATask) {
      tasks.push_back({i, t, std::min(triangles, t + kTrianglesATask)});
    }
  }
  const double nearest = view_distance(view, 0.0);
  std::vector<std::vector<Drawn>> parts(tasks.size());
  tbb::parallel_for(std::size_t{0}, tasks.size(), [&](std::size_t i) {
    const Task& task = tasks[i];
    const Object& object = scene.objects[task.object];
    const Mesh& mesh = object.mesh;
    for (std::size_t t = task.begin; t < task.end; ++t) {
      const auto& c = mesh.triangles[t];
      prepare(view, {mesh.positions[c[0]], mesh.positions[c[1]], mesh.positions[c[2]]},
              object.casts && !silhouettes[task.object].light_facing[t], nearest, parts[i]);
    }
  });
  std::vector<Drawn> all;
  for (const std::vector<Drawn>& part : parts) all.insert(all.end(), part.begin(), part.end());
  return all;
}

std::vector<std::vector<std::uint32_t>> in_bands(std::span<const Drawn> triangles, int bands) {
  std::vector<std::vector<std::uint32_t>> result(static_cast<std::size_t>(bands));
  for (std::size_t i = 0; i < triangles.size(); ++i) {
    const auto [low, high] = std::ranges::minmax(triangles[i].outline, {}, &SnappedPoint::y);
    const int first = std::max(0, (low.y >> 8) / kLightTile);
    const int last = std::min(bands - 1, (high.y >> 8) / kLightTile);
    for (int band = first; band <= last; ++band) {
      result[static_cast<std::size_t>(band)].push_back(static_cast<std::uint32_t>(i));
    }
  }
  return result;
}

// 1/z grows linearly along a row; the corners bound it where a triangle is seen edge-on.
void draw_row(const Drawn& triangle, int y, int x_begin, int x_end, float* texels) {
  const float at_row = triangle.b * (static_cast<float>(y) + 0.5F) + triangle.c;
  for (int x = x_begin; x < x_end; ++x) {
    const float inverse = std::clamp(triangle.a * (static_cast<float>(x) + 0.5F) + at_row,
                                     triangle.least, triangle.greatest);
    texels[x] = std::max(texels[x], inverse);
  }
}

// From the back of the first layer of casters to a place inside it.
void sink_into_casters(const float* surfaces, float* backs, int size) {
  for (int x = 0; x < size; ++x) {
    if (backs[x] > 0.0F) backs[x] += kFront * std::max(0.0F, surfaces[x] - backs[x]);
  }
}

void summarize(const LightDepths& casters, int band, std::span<TileDepths> tiles) {
  const int size = casters.size();
  for (TileDepths& tile : tiles) tile = {HUGE_VALF, 0.0F};
  for (int y = band * kLightTile; y < std::min(size, (band + 1) * kLightTile); ++y) {
    const float* row = casters.row(y);
    for (std::size_t t = 0; t < tiles.size(); ++t) {
      const int begin = static_cast<int>(t) * kLightTile;
      for (int x = begin; x < std::min(size, begin + kLightTile); ++x) {
        tiles[t].least = std::min(tiles[t].least, row[x]);
        tiles[t].greatest = std::max(tiles[t].greatest, row[x]);
      }
    }
  }
}

}  // namespace

ShadowMaps draw_shadow_maps(const Scene& scene, std::span<const Silhouette> silhouettes,
                            const Window& light_window) {
  const int size = light_window.width;
  const int bands = light_tiles(size);
  const auto tiles = static_cast<std::size_t>(bands);
  const std::vector<Drawn> triangles = prepare_all(scene, silhouettes, light_window);
  const std::vector<std::vector<std::uint32_t>> of_band = in_bands(triangles, bands);
  ShadowMaps maps{LightDepths(size), LightDepths(size), std::vector<TileDepths>(tiles * tiles)};
  std::vector<std::uint64_t> compared(tiles, 0);
  tbb::parallel_for(0, bands, [&](int band) {
    const auto b = static_cast<std::size_t>(band);
    const int y_begin = band * kLightTile;
    const int y_end = std::min(size, y_begin + kLightTile);
    for (int y = y_begin; y < y_end; ++y) {
      std::fill_n(maps.surfaces.row(y), size, 0.0F);
      std::fill_n(maps.casters.row(y), size, 0.0F);
    }
    for (const std::uint32_t i : of_band[b]) {
      const Drawn& triangle = triangles[i];
      for_each_span(triangle.outline, size, y_begin, y_end, [&](int y, int x_begin, int x_end) {
        draw_row(triangle, y, x_begin, x_end,
                 (triangle.back ? maps.casters : maps.surfaces).row(y));
        compared[b] += static_cast<std::uint64_t>(x_end - x_begin);
      });
    }
    for (int y = y_begin; y < y_end; ++y)
      sink_into_casters(maps.surfaces.row(y), maps.casters.row(y), size);
    summarize(maps.casters, band, std::span(maps.caster_tiles).subspan(b * tiles, tiles));
  });
  for (const std::uint64_t of_rows : compared) maps.compared += of_rows;
  return maps;
}

}  // namespace wedgesim::functional
