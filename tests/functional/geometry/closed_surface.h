#pragma once

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>

#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// How far a polyhedron is from what its faces claim, in units of its size.
struct SurfaceFaults {
  double not_planar = 0.0;   // a corner of a face off the face's plane
  double not_outside = 0.0;  // a vertex beyond a face's plane
  double not_closed = 0.0;   // the sum of all area vectors
  int wrong_way = 0;         // faces wound clockwise seen from outside
  int unmatched_edges = 0;   // directed edges whose opposite is not there as often
};

/// Six times the signed volume inside a surface, twice its area vector.
struct SurfaceSums {
  double volume6 = 0.0;
  glm::dvec3 area2{0.0};
  double area = 0.0;
};

inline SurfaceSums sums_of(const WorldWedge& volume) {
  SurfaceSums sums;
  const glm::dvec3 origin = volume.vertices.front();
  for (const WedgeFace& face : volume.faces) {
    glm::dvec3 area2(0.0);
    const glm::dvec3 a = volume.vertices[face.corners[0]] - origin;
    for (std::size_t i = 1; i + 1 < face.corners.size(); ++i) {
      const glm::dvec3 b = volume.vertices[face.corners[i]] - origin;
      const glm::dvec3 c = volume.vertices[face.corners[i + 1]] - origin;
      area2 += glm::cross(b - a, c - a);
      sums.volume6 += glm::dot(a, glm::cross(b, c));
    }
    sums.area2 += area2;
    sums.area += 0.5 * glm::length(area2);
  }
  return sums;
}

/// The extent of its vertices.
inline double size_of(const WorldWedge& volume) {
  Bounds bounds;
  for (const glm::dvec3& p : volume.vertices) bounds.grow(p);
  return bounds.diagonal();
}

inline SurfaceFaults faults_of(const WorldWedge& volume) {
  SurfaceFaults faults;
  const double size = size_of(volume);
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> balance;
  for (const WedgeFace& face : volume.faces) {
    const glm::dvec4& plane = volume.planes[face.plane];
    const glm::dvec3 inward(plane);
    const auto value = [&](std::uint32_t v) {
      return (glm::dot(inward, volume.vertices[v]) + plane.w) / size;
    };
    glm::dvec3 area2(0.0);
    const std::size_t n = face.corners.size();
    for (std::size_t i = 0; i < n; ++i) {
      const std::uint32_t a = face.corners[i];
      const std::uint32_t b = face.corners[(i + 1) % n];
      faults.not_planar = std::max(faults.not_planar, std::abs(value(a)));
      area2 += glm::cross(volume.vertices[a] - volume.vertices[face.corners[0]],
                          volume.vertices[b] - volume.vertices[face.corners[0]]);
      if (a < b) {
        ++balance[{a, b}];
      } else if (b < a) {
        --balance[{b, a}];
      }
    }
    // A sliver's way round is rounding.
    if (glm::dot(area2, inward) > 1e-5 * size * size) ++faults.wrong_way;
    for (std::uint32_t v = 0; v < volume.vertices.size(); ++v) {
      faults.not_outside = std::max(faults.not_outside, -value(v));
    }
  }
  for (const auto& [edge, count] : balance) faults.unmatched_edges += std::abs(count);
  faults.not_closed = glm::length(sums_of(volume).area2) / (size * size);
  return faults;
}

}  // namespace wedgesim::functional
