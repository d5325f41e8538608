#include "functional/geometry/disk_volumes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

namespace wedgesim::functional {
namespace {

// Of the rim between the extrusion points of neighbouring quads, one triangle spans at most this
// angle: its chord is within 1/2500 of the radius.
constexpr double kFanStep = 2.0 * M_PI / 112.0;

class Extruder {
 public:
  Extruder(const LightDisk& disk, const Mesh& mesh, double end_height)
      : disk_(disk), mesh_(mesh), end_height_(end_height) {}

  const LightDisk& disk() const { return disk_; }
  const glm::dvec3& vertex(std::uint32_t v) const { return mesh_.positions[v]; }

  // The point of the end plane on the ray from the rim through a vertex.
  glm::dvec3 reach(double angle, std::uint32_t v) const {
    const glm::dvec3 from = disk_.rim(angle);
    return from + end_height_ / disk_.height(vertex(v)) * (vertex(v) - from);
  }

  // \param edge_heights  of the silhouette edge at both ends
  void quad(const SilhouetteEdge& edge, double angle, const std::array<double, 2>& edge_heights,
            std::vector<VolumeTriangle>& triangles) const {
    const std::array<glm::dvec3, 4> p{vertex(edge.begin), vertex(edge.end), reach(angle, edge.end),
                                      reach(angle, edge.begin)};
    const std::array<double, 4> r{disk_.height(p[0]) / edge_heights[0],
                                  disk_.height(p[1]) / edge_heights[1],
                                  end_height_ / edge_heights[1], end_height_ / edge_heights[0]};
    triangles.push_back({{p[0], p[3], p[2]}, {r[0], r[3], r[2]}});
    triangles.push_back({{p[0], p[2], p[1]}, {r[0], r[2], r[1]}});
  }

  // At a vertex from one quad's extrusion point to the next one's, along the shorter arc.
  void fan(std::uint32_t v, double from, double to, double edge_height,
           std::vector<VolumeTriangle>& triangles) const {
    const double arc = std::remainder(to - from, 2.0 * M_PI);
    const int steps = static_cast<int>(std::ceil(std::abs(arc) / kFanStep));
    const double ratio = disk_.height(vertex(v)) / edge_height;
    const double end_ratio = end_height_ / edge_height;
    for (int i = 0; i < steps; ++i) {
      triangles.push_back(
          {{vertex(v), reach(from + arc * i / steps, v), reach(from + arc * (i + 1) / steps, v)},
           {ratio, end_ratio, end_ratio}});
    }
  }

 private:
  const LightDisk& disk_;
  const Mesh& mesh_;
  double end_height_;
};

// The sides that a silhouette loop casts. Where neighbouring quads part, at convex corners of the
// penumbra and at the others of the umbra, a fan closes the volume; elsewhere they overlap.
template <typename EdgeHeight>
void extrude_loop(const Extruder& extruder, const std::vector<SilhouetteEdge>& loop,
                  double ExtrusionAngles::*which, const EdgeHeight& edge_height,
                  std::vector<VolumeTriangle>& triangles) {
  std::vector<std::optional<double>> angles;
  for (const SilhouetteEdge& edge : loop) {
    const auto both =
        extrusion_angles(extruder.disk(), extruder.vertex(edge.begin), extruder.vertex(edge.end));
    angles.push_back(both ? std::optional((*both).*which) : std::nullopt);
    if (!both) continue;
    extruder.quad(edge, *angles.back(), {edge_height(edge.begin), edge_height(edge.end)},
                  triangles);
  }
  const bool fans_at_convex = which == &ExtrusionAngles::penumbra;
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const std::size_t next = (i + 1) % loop.size();
    if (!angles[i] || !angles[next]) continue;
    const glm::dvec3& a = extruder.vertex(loop[i].begin);
    const glm::dvec3& b = extruder.vertex(loop[i].end);
    const glm::dvec3 p = extruder.disk().rim(*angles[i]);
    const glm::dvec3 outward = glm::cross(a - p, b - p);
    const bool convex = glm::dot(outward, extruder.vertex(loop[next].end) - b) < 0.0;
    if (convex == fans_at_convex) {
      extruder.fan(loop[i].end, *angles[i], *angles[next], edge_height(loop[i].end), triangles);
    }
  }
}

// Of each vertex the height of its silhouette edge: 0 where it has none.
std::vector<double> silhouette_heights(const LightDisk& disk, const Mesh& mesh,
                                       const DiskSilhouettes& silhouettes,
                                       const std::vector<std::uint32_t>& belt) {
  std::vector<double> heights(mesh.positions.size(), 0.0);
  for (const auto& loop : silhouettes.penumbra.loops) {
    for (const SilhouetteEdge& edge : loop) {
      heights[edge.begin] = disk.height(mesh.positions[edge.begin]);
    }
  }
  std::vector<std::uint32_t> waiting = belt;
  std::vector<std::pair<std::uint32_t, double>> found;
  while (!waiting.empty()) {
    found.clear();
    std::erase_if(waiting, [&](std::uint32_t t) {
      double lowest = 0.0;  // of the corners that are known
      bool complete = true;
      for (const std::uint32_t v : mesh.triangles[t]) {
        complete &= heights[v] > 0.0;
        if (heights[v] > 0.0) lowest = lowest > 0.0 ? std::min(lowest, heights[v]) : heights[v];
      }
      if (complete) return true;
      if (lowest == 0.0) return false;
      for (const std::uint32_t v : mesh.triangles[t]) {
        if (heights[v] == 0.0) found.emplace_back(v, lowest);
      }
      return true;
    });
    if (found.empty()) break;
    for (const auto& [v, height] : found) {
      heights[v] = heights[v] > 0.0 ? std::min(heights[v], height) : height;
    }
  }
  return heights;
}

bool in_belt(DiskFacing facing) {
  return facing == DiskFacing::back_belt || facing == DiskFacing::front_belt;
}

}  // namespace

DiskSilhouettes find_disk_silhouettes(const LightDisk& disk, const Mesh& mesh) {
  DiskSilhouettes result;
  result.facings = disk_facings(disk, mesh);
  std::vector<std::uint8_t> some(result.facings.size());
  std::vector<std::uint8_t> all(result.facings.size());
  for (std::size_t t = 0; t < result.facings.size(); ++t) {
    some[t] = result.facings[t] != DiskFacing::none;
    all[t] = result.facings[t] == DiskFacing::all;
  }
  result.umbra = find_outline(mesh, std::move(some));
  result.penumbra = find_outline(mesh, std::move(all));
  return result;
}

DiskVolumes extrude_disk_volumes(const LightDisk& disk, const Mesh& mesh,
                                 const DiskSilhouettes& silhouettes, double end_height) {
  DiskVolumes volumes;
  const Extruder extruder(disk, mesh, end_height);
  std::vector<std::uint32_t> belt;
  for (std::size_t t = 0; t < silhouettes.facings.size(); ++t) {
    if (in_belt(silhouettes.facings[t])) belt.push_back(static_cast<std::uint32_t>(t));
  }
  const std::vector<double> heights = silhouette_heights(disk, mesh, silhouettes, belt);
  const auto edge_height = [&](std::uint32_t v) {
    const double own = disk.height(mesh.positions[v]);
    return heights[v] > 0.0 ? std::min(own, heights[v]) : own;
  };

  for (const std::uint32_t t : belt) {
    if (silhouettes.facings[t] != DiskFacing::back_belt) continue;
    VolumeTriangle face;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = mesh.triangles[t][i];
      face.corners[i] = mesh.positions[v];
      face.ratios[i] = disk.height(mesh.positions[v]) / edge_height(v);
    }
    volumes.back_belt.push_back(face);
  }
  for (const auto& loop : silhouettes.umbra.loops) {
    extrude_loop(extruder, loop, &ExtrusionAngles::umbra, edge_height, volumes.umbra);
  }
  for (const auto& loop : silhouettes.penumbra.loops) {
    extrude_loop(extruder, loop, &ExtrusionAngles::penumbra, edge_height, volumes.penumbra);
  }
  return volumes;
}

}  // namespace wedgesim::functional
