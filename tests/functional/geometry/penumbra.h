#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <iomanip>
#include <ostream>

#include "base/error.h"
#include "functional/geometry/wedge.h"
#include "functional/scene/scene.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {

/// A silhouette edge under a light, with room below: all rays through it end on one plane.
struct EdgeCase {
  Light light;
  glm::dvec3 begin{0.0}, end{0.0};
  EndPlane end_plane;
  int kind = 0;
};

inline std::ostream& operator<<(std::ostream& out, const EdgeCase& edge) {
  const auto put = [&](const glm::dvec3& p) {
    out << " (" << p.x << ", " << p.y << ", " << p.z << ')';
  };
  out << std::setprecision(17) << "kind " << edge.kind << ", edge";
  put(edge.begin);
  put(edge.end);
  out << ", light";
  put(edge.light.centre);
  put(edge.light.half_u);
  put(edge.light.half_v);
  return out << ", radius " << edge.light.radius;
}

/// A point of the light: a corner or edge of a rectangle often, the surface of a sphere mostly.
inline glm::dvec3 light_point(Random& random, const Light& light) {
  if (light.shape == LightShape::rectangle) {
    const auto coordinate = [&] {
      return random.chance(0.5) ? (random.chance(0.5) ? 1.0 : -1.0) : random.uniform(-1.0, 1.0);
    };
    const double u = coordinate();
    return light.centre + u * light.half_u + coordinate() * light.half_v;
  }
  const double share = random.chance(0.8) ? 1.0 : random.uniform(0.0, 1.0);
  return light.centre + share * light.radius * random.direction();
}

/// A light high above, turned a little, rectangle or sphere.
inline Light random_light(Random& random, LightShape shape) {
  Light light;
  light.shape = shape;
  light.centre = random.in_box({-4.0, 9.0, -4.0}, {4.0, 13.0, 4.0});
  if (shape == LightShape::sphere) {
    light.radius = random.uniform(0.05, 1.5);
    return light;
  }
  const glm::dvec3 way = glm::normalize(random.in_box({-0.3, -1.0, -0.3}, {0.3, -1.0, 0.3}));
  light.half_u = glm::normalize(glm::cross(way, glm::dvec3(0.3, 0.1, 1.0)));
  light.half_v = glm::normalize(glm::cross(way, light.half_u));
  if (random.chance(0.3)) {  // level, as lights often are
    light.half_u = {1.0, 0.0, 0.0};
    light.half_v = {0.0, 0.0, 1.0};
  }
  light.half_u *= random.uniform(0.05, 1.5);
  light.half_v *= random.uniform(0.05, 1.5);
  return light;
}

/// Where receivers are.
inline const glm::dvec3 kReceiversLow{-6.0, 0.0, -6.0};
inline const glm::dvec3 kReceiversHigh{6.0, 6.5, 6.0};

/// Chooses the end plane as for a caster that has this edge alone.
inline void choose_end(EdgeCase& edge) {
  Mesh caster;
  caster.positions = {edge.begin, edge.end};
  Silhouette silhouette;
  silhouette.loops = {{{0, 1}, {1, 0}}};
  Bounds bounds;
  bounds.grow(kReceiversLow);
  bounds.grow(kReceiversHigh);
  for (const glm::dvec3& p : caster.positions) bounds.grow(p);
  edge.end_plane = choose_end_plane(caster, silhouette, edge.light, bounds, std::nullopt);
}

/// Edges of all kinds: any, level, ends at very different distances, pointing at a point of the
/// light more or less exactly, very short.
inline EdgeCase any_edge(Random& random, LightShape shape) {
  EdgeCase edge;
  edge.light = random_light(random, shape);
  edge.begin = random.in_box({-3.0, 0.5, -3.0}, {3.0, 6.0, 3.0});
  const glm::dvec3 to_light = light_point(random, edge.light) - edge.begin;
  edge.kind = random.whole(0, 5);
  switch (edge.kind) {
    case 0:
      edge.end = random.in_box({-3.0, 0.5, -3.0}, {3.0, 6.0, 3.0});
      break;
    case 1:
      edge.end = edge.begin + random.in_box({-2.0, 0.0, -2.0}, {2.0, 0.0, 2.0});
      break;
    case 2:  // one end close to the light
      edge.end = edge.begin + random.uniform(0.4, 0.6) * to_light +
                 random.uniform(0.0, 0.5) * random.direction();
      break;
    case 3:  // points at the light, off by anything down to rounding
      edge.end = edge.begin + random.uniform(0.1, 0.3) * to_light +
                 std::pow(10.0, random.uniform(-17.0, -1.0)) * random.direction();
      break;
    case 4:
      edge.end = edge.begin + std::pow(10.0, random.uniform(-9.0, -2.0)) * random.direction();
      break;
    default:
      edge.end = edge.begin + random.uniform(0.01, 1.0) * random.direction();
      break;
  }
  if (random.chance(0.5)) std::swap(edge.begin, edge.end);
  return edge;
}

/// The same, without edges that touch the light or a rectangle's plane.
inline EdgeCase random_edge(Random& random, LightShape shape) {
  for (;;) {
    EdgeCase edge = any_edge(random, shape);
    const Light& light = edge.light;
    const glm::dvec3 normal = glm::cross(light.half_u, light.half_v);
    const auto clear = [&](double share) {
      const glm::dvec3 way = edge.begin + share * (edge.end - edge.begin) - light.centre;
      return shape == LightShape::rectangle ? glm::dot(normal, way) > 0.0
                                            : glm::length(way) > 1.001 * light.radius;
    };
    const glm::dvec3 along = edge.end - edge.begin;
    const double nearest =
        std::clamp(glm::dot(light.centre - edge.begin, along) / glm::dot(along, along), 0.0, 1.0);
    if (!clear(0.0) || !clear(1.0) || !clear(nearest)) continue;
    try {
      choose_end(edge);
      return edge;
    } catch (const InputError&) {
      // Some ray of its penumbra never ends.
    }
  }
}

/// A point of the penumbra: on a ray from the light through the edge, behind it.
inline glm::dvec3 penumbra_point(Random& random, const EdgeCase& edge) {
  const double along =
      random.chance(0.3) ? (random.chance(0.5) ? 0.0 : 1.0) : random.uniform(0.0, 1.0);
  const glm::dvec3 s = edge.begin + along * (edge.end - edge.begin);
  const glm::dvec3 far = edge.end_plane.reach(light_point(random, edge.light), s);
  return s + random.uniform(0.0, 1.0) * (far - s);
}

}  // namespace wedgesim::functional
