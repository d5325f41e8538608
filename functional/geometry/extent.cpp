#include "functional/geometry/extent.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <limits>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

constexpr double kGrazingSine = 0.05;   // a side of the bounds this edge-on is not chosen
constexpr double kSmallestSine = 1e-3;  // a ray this parallel to the plane never ends

double dot(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

// The longest way from the silhouette to the plane along any ray of the penumbra, or infinity if a
// ray meets the plane at a sine below `smallest_sine` or not at all.
double longest_way(const glm::dvec4& plane, const Mesh& caster, const Silhouette& silhouette,
                   const Light& light, double smallest_sine) {
  const std::vector<glm::dvec3> corners = light_corners(light);
  double longest = 0.0;
  for (const auto& loop : silhouette.loops) {
    for (const SilhouetteEdge& edge : loop) {
      const glm::dvec3& v = caster.positions[edge.begin];
      for (const glm::dvec3& corner : corners) {
        const glm::dvec3 ray = v - corner;
        const double distance = glm::length(ray);
        double sine = -glm::dot(glm::dvec3(plane), ray) / distance;
        if (light.shape == LightShape::sphere && light.radius > 0.0) {
          // Sphere: the ray of its penumbra cone that meets the plane at the least angle. The
          // wedge's corners lie outside the cone: twice the angle bounds them.
          const double half_angle = std::asin(std::min(1.0, light.radius / distance));
          const double angle = std::asin(std::clamp(sine, -1.0, 1.0)) - 2.0 * half_angle;
          sine = std::sin(std::max(angle, -1.5));
        }
        if (!(sine > smallest_sine)) return std::numeric_limits<double>::infinity();
        longest = std::max(longest, std::abs(dot(plane, v)) / sine);
      }
    }
  }
  return longest;
}

glm::dvec3 mean_position(const Mesh& mesh) {
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : mesh.positions) sum += p;
  return sum / static_cast<double>(mesh.positions.size());
}

// The plane across `direction` that lies `beyond` behind the farthest of the points.
template <typename Points>
glm::dvec4 plane_behind(const glm::dvec3& direction, const Points& points, double beyond) {
  double farthest = -std::numeric_limits<double>::infinity();
  for (const glm::dvec3& p : points) farthest = std::max(farthest, glm::dot(direction, p));
  return {-direction, farthest + beyond};
}

std::vector<glm::dvec3> corners_of(const Bounds& bounds) {
  std::vector<glm::dvec3> corners;
  for (int i = 0; i < 8; ++i) {
    corners.emplace_back((i & 1) != 0 ? bounds.high.x : bounds.low.x,
                         (i & 2) != 0 ? bounds.high.y : bounds.low.y,
                         (i & 4) != 0 ? bounds.high.z : bounds.low.z);
  }
  return corners;
}

}  // namespace

void Bounds::grow(const glm::dvec3& p) {
  low = glm::min(low, p);
  high = glm::max(high, p);
}

double Bounds::diagonal() const { return glm::length(high - low); }

Bounds bounds_of(std::span<const Object> objects) {
  Bounds bounds;
  for (const Object& object : objects) {
    for (const glm::dvec3& p : object.mesh.positions) bounds.grow(p);
  }
  return bounds;
}

bool EndPlane::is_before(const glm::dvec3& p) const { return dot(plane, p) > 0.0; }

glm::dvec3 EndPlane::reach(const glm::dvec3& from, const glm::dvec3& through) const {
  const glm::dvec3 ray = through - from;
  return through + (dot(plane, through) / -glm::dot(glm::dvec3(plane), ray)) * ray;
}

std::vector<glm::dvec3> light_corners(const Light& light) {
  if (light.shape != LightShape::rectangle) return {light.centre};
  return {light.centre - light.half_u - light.half_v, light.centre + light.half_u - light.half_v,
          light.centre + light.half_u + light.half_v, light.centre - light.half_u + light.half_v};
}

EndPlane choose_end_plane(const Mesh& caster, const Silhouette& silhouette, const Light& light,
                          const Bounds& bounds, std::optional<double> length) {
  const glm::dvec3 to_caster = glm::normalize(mean_position(caster) - light.centre);
  const double beyond = kEndMargin * bounds.diagonal();
  const glm::dvec3 across = light.shape == LightShape::rectangle
                                ? glm::normalize(glm::cross(light.half_u, light.half_v))
                                : to_caster;
  EndPlane best;
  double best_way = std::numeric_limits<double>::infinity();
  const auto consider = [&](EndSide side, const glm::dvec4& plane, double smallest_sine) {
    const double way = longest_way(plane, caster, silhouette, light, smallest_sine);
    if (way < best_way) {
      best_way = way;
      best = {plane, side};
    }
  };
  if (length) {
    consider(EndSide::fixed_length, plane_behind(to_caster, caster.positions, *length),
             kSmallestSine);
  } else {
    for (int axis = 0; axis < 3; ++axis) {
      glm::dvec3 direction(0.0);
      direction[axis] = 1.0;
      const auto low = static_cast<EndSide>(2 * axis);
      const auto high = static_cast<EndSide>(2 * axis + 1);
      consider(low, {direction, -bounds.low[axis] + beyond}, kGrazingSine);
      consider(high, {-direction, bounds.high[axis] + beyond}, kGrazingSine);
    }
  }
  if (std::isinf(best_way) && length) {
    throw InputError(caster.name,
                     "a ray of its penumbra never reaches the plane at the fixed length",
                     "automatic length");
  }
  if (std::isinf(best_way)) {
    consider(EndSide::across_light, plane_behind(across, corners_of(bounds), beyond),
             kSmallestSine);
  }
  if (std::isinf(best_way)) {
    consider(EndSide::across_way, plane_behind(to_caster, corners_of(bounds), beyond),
             kSmallestSine);
  }
  if (std::isinf(best_way)) {
    throw InputError(caster.name, "the light touches, surrounds or is too close to this caster",
                     "a penumbra that spans less than a half-space");
  }
  return best;
}

}  // namespace wedgesim::functional
