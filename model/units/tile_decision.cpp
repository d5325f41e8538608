#include "model/units/tile_decision.h"

#include <algorithm>

namespace wedgesim::model::units {
namespace {

using datapath::FixedBox;
using datapath::FixedPlane;

// Of the box's two depths the one in front for the eye: far in z-pass, near in z-fail, so that
// both methods read alike; `at(box, z)` is the box at one depth.
FixedBox at(FixedBox box, std::int64_t z) {
  box.low.z = z;
  box.high.z = z;
  return box;
}

// Does the inside of a plane lie beyond it (z-fail: before it)? If not, the polygon is seen edge-on
// and its plane decides nothing.
bool agrees(const FixedPlane& plane, bool z_fail) {
  const std::int64_t c = plane.minus ? -plane.form.c : plane.form.c;
  return z_fail ? c <= 0 : c >= 0;
}

bool before(const ZSpan& z, const FixedBox& box) { return z.max < box.low.z; }
bool beyond(const ZSpan& z, const FixedBox& box) { return z.min > box.high.z; }

bool culls_zmax(const SetupFace& face, const FixedBox& box, bool z_fail) {
  if (z_fail ? before(face.z, box) : beyond(face.z, box)) return true;
  return agrees(face.plane, z_fail) &&
         !reaches(face.plane, at(box, z_fail ? box.low.z : box.high.z));
}

bool culls_planes(const SetupPrimitive& primitive, const FixedBox& box) {
  return std::any_of(primitive.planes.begin(), primitive.planes.end(),
                     [&](const FixedPlane& plane) { return !reaches(plane, box); });
}

bool culls_sat(const SetupPrimitive& primitive, const FixedBox& box) {
  constexpr std::int64_t kSnap = 2;  // 1/256 pixel: more than snapping moves a vertex
  const FixedBox& v = primitive.vertices;
  return v.low.x > 128 * box.high.x + kSnap || v.high.x < 128 * box.low.x - kSnap ||
         v.low.y > 128 * box.high.y + kSnap || v.high.y < 128 * box.low.y - kSnap ||
         v.low.z > box.high.z || v.high.z < box.low.z;
}

}  // namespace

Cull cull_face(Cull enabled, const SetupPrimitive& primitive, const SetupFace& face,
               const FixedBox& box, bool z_fail) {
  const bool both = enabled == Cull::both || enabled == Cull::sat;
  if (enabled == Cull::zmax && culls_zmax(face, box, z_fail)) return Cull::zmax;
  if ((both || enabled == Cull::zrange) && (before(primitive.z, box) || beyond(primitive.z, box))) {
    return Cull::zrange;
  }
  if ((both || enabled == Cull::planes) && culls_planes(primitive, box)) return Cull::planes;
  if (enabled == Cull::sat && culls_sat(primitive, box)) return Cull::sat;
  return Cull::none;
}

bool inside_wedge(const SetupPrimitive& primitive, const FixedBox& box) {
  return primitive.z.holds(box.low.z) && primitive.z.holds(box.high.z) &&
         std::all_of(primitive.planes.begin(), primitive.planes.end(),
                     [&](const FixedPlane& plane) { return holds(plane, box); });
}

UmbraDecision decide_umbra(UmbraCull cull, Accept accept, const SetupUmbra& umbra,
                           const FixedBox& box, bool z_fail) {
  const FixedPlane hit = umbra.hit_plane();
  const bool facing = agrees(hit, z_fail);
  const ZSpan& z = umbra.z;
  if (cull == UmbraCull::zmax) {
    // Past the polygon's far end every pixel is hit, whatever the plane says.
    const bool decides = facing && (z_fail ? box.low.z >= z.min : box.high.z <= z.max);
    if ((z_fail ? before(z, box) : beyond(z, box)) ||
        (decides && !reaches(hit, at(box, z_fail ? box.low.z : box.high.z)))) {
      return UmbraDecision::culled;
    }
  }
  if (accept == Accept::zmin) {
    // Before its near end none is.
    const bool decides = facing && (z_fail ? box.high.z <= z.max : box.low.z >= z.min);
    if ((z_fail ? beyond(z, box) : before(z, box)) ||
        (decides && holds(hit, at(box, z_fail ? box.high.z : box.low.z)))) {
      return UmbraDecision::accepted;
    }
  }
  return UmbraDecision::read;
}

}  // namespace wedgesim::model::units
