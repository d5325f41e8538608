#include "functional/reference/judge_end.h"

#include <array>
#include <vector>

namespace wedgesim::functional {
namespace {

// The corners of the bounds of all that receives, relative to a place.
std::array<RealVector, 8> receiver_corners(const Scene& scene, const Frame& frame,
                                           const RealVector& from) {
  Bounds bounds;
  RealVector origin(glm::dvec3(0.0));
  if (frame.depth_given) {
    bounds = frame.receivers;
    origin = RealVector(frame.origin);
  } else {
    for (const Object& object : scene.objects) {
      for (const glm::dvec3& p : object.mesh.positions) bounds.grow(p);
    }
  }
  std::array<RealVector, 8> corners;
  for (std::size_t i = 0; i < corners.size(); ++i) {
    const glm::dvec3 corner((i & 1U) != 0 ? bounds.high.x : bounds.low.x,
                            (i & 2U) != 0 ? bounds.high.y : bounds.low.y,
                            (i & 4U) != 0 ? bounds.high.z : bounds.low.z);
    corners[i] = origin + RealVector(corner) - from;
  }
  return corners;
}

// From the light's centre to the middle of an object's vertices.
RealVector way_to(const Mesh& mesh, const RealVector& centre) {
  RealVector sum;
  for (const glm::dvec3& p : mesh.positions) sum = sum + (RealVector(p) - centre);
  return unit(sum);
}

RealVector outward_of(EndSide side, const Scene& scene, const Mesh& mesh) {
  switch (side) {
    case EndSide::low_x:
      return {-1, 0, 0};
    case EndSide::high_x:
      return {1, 0, 0};
    case EndSide::low_y:
      return {0, -1, 0};
    case EndSide::high_y:
      return {0, 1, 0};
    case EndSide::low_z:
      return {0, 0, -1};
    case EndSide::high_z:
      return {0, 0, 1};
    case EndSide::across_light:
      if (scene.light.shape == LightShape::rectangle) {
        return unit(cross(RealVector(scene.light.half_u), RealVector(scene.light.half_v)));
      }
      break;
    case EndSide::across_way:
    case EndSide::fixed_length:
      break;
  }
  return way_to(mesh, RealVector(scene.light.centre));
}

}  // namespace

RealPlane judged_end(const Scene& scene, const Frame& frame, std::size_t object) {
  const EndSide side = frame.geometry.end_sides[object];
  const Mesh& mesh = scene.objects[object].mesh;
  const RealVector centre(scene.light.centre);
  const RealVector outward = outward_of(side, scene, mesh);
  std::vector<RealVector> points;
  Real beyond;
  if (side == EndSide::fixed_length) {
    for (const glm::dvec3& p : mesh.positions) points.push_back(RealVector(p) - centre);
    beyond = *frame.length;
  } else {
    const auto corners = receiver_corners(scene, frame, centre);
    points.assign(corners.begin(), corners.end());
    const RealVector diagonal = corners.back() - corners.front();
    beyond = kEndMargin * sqrt(dot(diagonal, diagonal));
  }
  Real farthest = dot(outward, points.front());
  for (const RealVector& p : points) {
    const Real along = dot(outward, p);
    if (along > farthest) farthest = along;
  }
  return {Real(-1) * outward, Real(farthest + beyond) * outward};
}

}  // namespace wedgesim::functional
