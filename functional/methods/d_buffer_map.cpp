#include "functional/methods/d_buffer_map.h"

#include <tbb/enumerable_thread_specific.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "functional/methods/d_buffer_band.h"

namespace wedgesim::functional {
namespace {

constexpr double kBeforeFirstVertex = 0.999;  // the near plane, of the least height of a caster

LightView view_of(const Scene& scene, const LightDisk& disk,
                  const std::vector<DiskVolumes>& volumes, int resolution) {
  std::vector<glm::dvec3> points;
  double least = std::numeric_limits<double>::infinity();
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      points.push_back(p);
      least = std::min(least, disk.height(p));
    }
  }
  for (const DiskVolumes& caster : volumes) {
    for (const VolumeTriangle& triangle : caster.penumbra) {
      points.insert(points.end(), triangle.corners.begin(), triangle.corners.end());
    }
  }
  if (points.empty()) return {};
  return make_light_view(disk.centre, disk.normal, kBeforeFirstVertex * least, points, resolution);
}

using Input = MapTriangles::Input;

// What volumes and surfaces are as a map's triangles.
class Inputs {
 public:
  Inputs(const LightView& view, Distances distances)
      : eye_(view.eye), interpolated_(distances == Distances::interpolated) {}

  Input surface(const Mesh& mesh, std::size_t triangle, std::uint8_t tag) const {
    const auto& t = mesh.triangles[triangle];
    Input input{{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]}};
    input.tag = tag;
    if (interpolated_) input.value = distances(input.corners);
    return input;
  }
  Input side(const VolumeTriangle& triangle, std::uint8_t tag, bool one_sided) const {
    Input input{triangle.corners};
    input.tag = tag;
    input.one_sided = one_sided;
    input.other = triangle.ratios;
    if (!interpolated_) return input;
    input.value = distances(triangle.corners);
    for (std::size_t i = 0; i < 3; ++i) input.other[i] = input.value[i] / triangle.ratios[i];
    return input;
  }

 private:
  std::array<double, 3> distances(const MapTriangles::Corners& corners) const {
    return {glm::distance(corners[0], eye_), glm::distance(corners[1], eye_),
            glm::distance(corners[2], eye_)};
  }
  glm::dvec3 eye_;
  bool interpolated_;
};

MapTriangles receivers_of(const Scene& scene, const LightView& view, const Inputs& inputs) {
  std::vector<Input> triangles;
  for (const Object& object : scene.objects) {
    if (object.casts) continue;
    for (std::size_t t = 0; t < object.mesh.triangles.size(); ++t) {
      triangles.push_back(inputs.surface(object.mesh, t, 0));
    }
  }
  return {view, triangles.size(), [&](std::size_t i) { return triangles[i]; }};
}

DBufferCaster caster_of(const Mesh& mesh, const DiskSilhouettes& silhouettes,
                        const DiskVolumes& volumes, const LightView& view, const Inputs& inputs) {
  const auto face = [&](std::size_t i) {
    const bool lit = silhouettes.facings[i] != DiskFacing::none;
    return inputs.surface(mesh, i, lit ? DBufferCaster::kLit : 0);
  };
  const std::size_t quads = volumes.umbra.size();
  const auto umbra_side = [&](std::size_t i) {
    return i < quads ? inputs.side(volumes.umbra[i], DBufferCaster::kQuad, false)
                     : inputs.side(volumes.back_belt[i - quads], 0, false);
  };
  const auto penumbra_side = [&](std::size_t i) {
    return inputs.side(volumes.penumbra[i], 0, true);
  };
  return {{view, mesh.triangles.size(), face},
          {view, quads + volumes.back_belt.size(), umbra_side},
          {view, volumes.penumbra.size(), penumbra_side}};
}

}  // namespace

DBuffer draw_d_buffer(const Scene& scene, const LightDisk& disk,
                      const std::vector<DiskSilhouettes>& silhouettes,
                      const std::vector<DiskVolumes>& volumes, const DBufferOptions& options) {
  DBuffer map;
  map.view = view_of(scene, disk, volumes, options.resolution);
  map.width = map.view.width;
  if (map.width == 0) return map;

  const Inputs inputs(map.view, options.distances);
  DBufferDrawing drawing{map.view, options, receivers_of(scene, map.view, inputs), {}};
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    const std::size_t i = drawing.casters.size();
    drawing.casters.push_back(caster_of(object.mesh, silhouettes[i], volumes[i], map.view, inputs));
  }
  const std::size_t texels =
      static_cast<std::size_t>(map.width) * static_cast<std::size_t>(map.width);
  map.texels = std::make_unique_for_overwrite<DBuffer::Texel[]>(texels);
  if (options.two_edges) map.penumbra_edge = std::make_unique_for_overwrite<float[]>(texels);
  const auto bands = static_cast<std::size_t>(MapTriangles::bands(map.width));
  std::vector<DBuffer::Count> counts(bands);
  tbb::enumerable_thread_specific<DBufferBand> scratch(map.width);
  tbb::parallel_for(std::size_t{0}, bands, [&](std::size_t band) {
    draw_d_buffer_band(drawing, static_cast<int>(band), scratch.local(), map, counts[band]);
  });
  for (const DBuffer::Count& count : counts) {
    map.count.tests += count.tests;
    map.count.writes += count.writes;
  }
  return map;
}

}  // namespace wedgesim::functional
