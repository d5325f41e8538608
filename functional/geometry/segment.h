#pragma once

#include <glm/geometric.hpp>
#include <glm/vec3.hpp>
#include <optional>

namespace wedgesim::functional {

/// Where a segment from `from` to `to` crosses a triangle: the share of its length, in (0, 1).
/// Source: Möller and Trumbore's test, in double precision.
inline std::optional<double> segment_triangle(const glm::dvec3& from, const glm::dvec3& to,
                                              const glm::dvec3& a, const glm::dvec3& b,
                                              const glm::dvec3& c) {
  const glm::dvec3 way = to - from;
  const glm::dvec3 ab = b - a;
  const glm::dvec3 ac = c - a;
  const glm::dvec3 p = glm::cross(way, ac);
  const double det = glm::dot(ab, p);
  if (det == 0.0) return std::nullopt;
  const glm::dvec3 s = from - a;
  const double u = glm::dot(s, p) / det;
  if (u < 0.0 || u > 1.0) return std::nullopt;
  const glm::dvec3 q = glm::cross(s, ab);
  const double v = glm::dot(way, q) / det;
  if (v < 0.0 || u + v > 1.0) return std::nullopt;
  const double t = glm::dot(ac, q) / det;
  if (!(t > 0.0 && t < 1.0)) return std::nullopt;
  return t;
}

}  // namespace wedgesim::functional
