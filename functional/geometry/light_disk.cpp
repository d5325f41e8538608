#include "functional/geometry/light_disk.h"

#include <tbb/blocked_range.h>
#include <tbb/parallel_for.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// A point in the disk's frame.
struct DiskPoint {
  glm::dvec2 across;  // radii
  double height;      // world units
};

DiskPoint in_frame(const LightDisk& disk, const glm::dvec3& p) {
  const glm::dvec3 way = p - disk.centre;
  return {glm::dvec2(glm::dot(way, disk.u), glm::dot(way, disk.v)) / disk.radius,
          glm::dot(way, disk.normal)};
}

}  // namespace

double LightDisk::height(const glm::dvec3& p) const { return glm::dot(p - centre, normal); }

glm::dvec3 LightDisk::rim(double angle) const {
  return centre + radius * (std::cos(angle) * u + std::sin(angle) * v);
}

LightDisk disk_of(const Light& light, const glm::dvec3& towards) {
  LightDisk disk;
  disk.centre = light.centre;
  if (light.shape == LightShape::rectangle) {
    const glm::dvec3 across = glm::cross(light.half_u, light.half_v);
    disk.normal = glm::normalize(across);
    disk.u = glm::normalize(light.half_u);
    disk.v = glm::cross(disk.normal, disk.u);
    disk.radius = std::sqrt(4.0 * glm::length(across) / M_PI);
  } else {
    disk.normal = glm::normalize(towards - light.centre);
    const Across across(disk.normal);
    disk.u = across.u;
    disk.v = across.v;
    disk.radius = light.radius;
  }
  return disk;
}

DiskFacing disk_facing(const LightDisk& disk, const std::array<glm::dvec3, 3>& triangle) {
  const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
  const double centre = glm::dot(normal, disk.centre - triangle[0]);
  // As printed, Eq. 1 has the two points interchanged and does not normalize the way to them.
  const glm::dvec2 across(glm::dot(normal, disk.u), glm::dot(normal, disk.v));
  const double reach = disk.radius * glm::length(across);
  if (centre + reach <= 0.0) return DiskFacing::none;
  if (centre - reach > 0.0) return DiskFacing::all;
  return centre > 0.0 ? DiskFacing::front_belt : DiskFacing::back_belt;
}

std::vector<DiskFacing> disk_facings(const LightDisk& disk, const Mesh& mesh) {
  std::vector<DiskFacing> facings(mesh.triangles.size());
  const tbb::blocked_range<std::size_t> all(0, facings.size(), 4096);
  tbb::parallel_for(all, [&](const tbb::blocked_range<std::size_t>& range) {
    for (std::size_t t = range.begin(); t < range.end(); ++t) {
      const auto& corner = mesh.triangles[t];
      facings[t] = disk_facing(
          disk, {mesh.positions[corner[0]], mesh.positions[corner[1]], mesh.positions[corner[2]]});
    }
  });
  return facings;
}

std::optional<ExtrusionAngles> extrusion_angles(const LightDisk& disk, const glm::dvec3& begin,
                                                const glm::dvec3& end) {
  const DiskPoint a = in_frame(disk, begin);
  const DiskPoint b = in_frame(disk, end);
  // The edge's line meets the disk's plane at meet / weight, infinitely far if it is parallel to
  // it: both cases at once. The points that tangents from there touch are on its polar line.
  const glm::dvec2 meet = a.across * b.height - b.across * a.height;
  const double weight = b.height - a.height;
  const double length = glm::length(meet);
  if (!(length > std::abs(weight))) return std::nullopt;
  const double towards = std::atan2(meet.y, meet.x);
  const double apart = std::acos(weight / length);
  const auto centre_inside = [&](double angle) {
    const glm::dvec3 p = disk.rim(angle);
    return glm::dot(glm::cross(begin - p, end - p), disk.centre - begin) <= 0.0;
  };
  const double first = towards + apart;
  const double second = towards - apart;
  if (centre_inside(first)) return ExtrusionAngles{first, second};
  return ExtrusionAngles{second, first};
}

}  // namespace wedgesim::functional
