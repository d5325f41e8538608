#include "model/count/tile_test.h"

#include <algorithm>

namespace wedgesim::model::tile_test {
namespace {

// A polygon whose plane, by its own coefficients, faces the other way than its snapped outline is
// seen nearly edge-on; its plane then decides nothing.
bool agrees(const Plane& plane, ZMethod method) {
  return method == ZMethod::pass ? plane.inward_c() >= 0.0 : plane.inward_c() <= 0.0;
}

}  // namespace

bool culls_zmax(const RasterFace& face, const Box& box, ZMethod method) {
  const bool pass = method == ZMethod::pass;
  if (pass ? face.z.min > box.z.max : face.z.max < box.z.min) return true;
  return agrees(face.plane, method) && !face.plane.reaches(box, pass ? box.z.max : box.z.min);
}

bool culls_zrange(const Primitive& wedge, const Box& box) {
  return wedge.z.min > box.z.max || wedge.z.max < box.z.min;
}

bool culls_planes(const Primitive& wedge, const Box& box) {
  return std::any_of(wedge.planes.begin(), wedge.planes.end(), [&](const Plane& plane) {
    return !plane.reaches(box, plane.inward_c() >= 0.0 ? box.z.max : box.z.min);
  });
}

bool culls_sat(const Primitive& wedge, const Box& box) {
  constexpr double kSnap = 1.0 / 128.0;  // pixels: more than snapping moves a vertex
  const Box& vertices = wedge.vertex_box;
  return vertices.x0 > box.x1 + kSnap || vertices.x1 < box.x0 - kSnap ||
         vertices.y0 > box.y1 + kSnap || vertices.y1 < box.y0 - kSnap ||
         vertices.z.min > box.z.max || vertices.z.max < box.z.min;
}

bool is_inside(const Primitive& wedge, const Box& box) {
  return box.z.min >= wedge.z.min && box.z.max <= wedge.z.max &&
         std::all_of(wedge.planes.begin(), wedge.planes.end(), [&](const Plane& plane) {
           return plane.holds(box, plane.inward_c() >= 0.0 ? box.z.min : box.z.max);
         });
}

bool culls_umbra(const RasterUmbra& umbra, const Box& box, ZMethod method) {
  const Plane hit = umbra.hit_plane();
  // Beyond the polygon's far end every pixel is hit, whatever the plane says.
  if (method == ZMethod::pass) {
    if (umbra.z.min > box.z.max) return true;
    return agrees(hit, method) && box.z.max <= umbra.z.max && !hit.reaches(box, box.z.max);
  }
  if (umbra.z.max < box.z.min) return true;
  return agrees(hit, method) && box.z.min >= umbra.z.min && !hit.reaches(box, box.z.min);
}

bool accepts_umbra(const RasterUmbra& umbra, const Box& box, ZMethod method) {
  const Plane hit = umbra.hit_plane();
  // Before the polygon's near end no pixel is hit, whatever the plane says.
  if (method == ZMethod::pass) {
    if (umbra.z.max < box.z.min) return true;
    return agrees(hit, method) && box.z.min >= umbra.z.min && hit.holds(box, box.z.min);
  }
  if (umbra.z.min > box.z.max) return true;
  return agrees(hit, method) && box.z.max <= umbra.z.max && hit.holds(box, box.z.max);
}

}  // namespace wedgesim::model::tile_test
