#pragma once

#include <array>
#include <glm/vec3.hpp>
#include <vector>

#include "functional/geometry/light_disk.h"
#include "functional/geometry/silhouette.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The silhouettes of a closed mesh for a light disk (seed 002, section 2.1).
struct DiskSilhouettes {
  std::vector<DiskFacing> facings;  // of each triangle
  Silhouette umbra;                 // between none-frontfacing triangles and the others
  Silhouette penumbra;              // between all-frontfacing triangles and the others
};
DiskSilhouettes find_disk_silhouettes(const LightDisk& disk, const Mesh& mesh);

/// A triangle of an umbra or penumbra volume, wound counter-clockwise seen from outside it.
struct VolumeTriangle {
  std::array<glm::dvec3, 3> corners;
  /// Of each corner its height above the disk divided by that of the silhouette edge e that cast it
  /// there: |cx_v| / |cx_s| along the ray from the disk's centre through it (Eq. 2). At least 1.
  std::array<double, 3> ratios;
};

/// The sides of both volumes of a caster, extruded to a plane parallel to the disk.
struct DiskVolumes {
  std::vector<VolumeTriangle> umbra;      // untrimmed quads, two triangles each
  std::vector<VolumeTriangle> penumbra;   // quads, and fans between neighbours at convex corners
  std::vector<VolumeTriangle> back_belt;  // silhouette faces behind which the centre is (3.3)
};

/// \param end_height  of the plane, above every caster and receiver
/// The silhouette edge of an umbra quad is its own edge where both silhouettes share it, otherwise
/// the vertex of the penumbra silhouette that is fewest edges away across silhouette faces; theirs
/// too. So |cx_s| is continuous over the umbra volume and its silhouette faces.
DiskVolumes extrude_disk_volumes(const LightDisk& disk, const Mesh& mesh,
                                 const DiskSilhouettes& silhouettes, double end_height);

}  // namespace wedgesim::functional
