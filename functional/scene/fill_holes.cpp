#include "functional/scene/fill_holes.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <numeric>
#include <optional>
#include <set>
#include <utility>
#include <vector>

#include "functional/scene/triangulate.h"

namespace wedgesim::functional {
namespace {

using Loop = std::vector<std::uint32_t>;

/// Loops round the holes, in the direction that a triangle in the hole would run.
std::vector<Loop> hole_loops(const Mesh& mesh) {
  std::map<std::pair<std::uint32_t, std::uint32_t>, int> uses;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      ++uses[std::minmax({t[k], t[(k + 1) % 3]})];
    }
  }
  std::multimap<std::uint32_t, std::uint32_t> next;
  for (const auto& t : mesh.triangles) {
    for (std::size_t k = 0; k < 3; ++k) {
      if (uses[std::minmax({t[k], t[(k + 1) % 3]})] == 1) {
        next.emplace(t[(k + 1) % 3], t[k]);
      }
    }
  }
  std::vector<Loop> loops;
  while (!next.empty()) {
    Loop path{next.begin()->first};
    for (auto step = next.find(path.back()); step != next.end(); step = next.find(path.back())) {
      const std::uint32_t to = step->second;
      next.erase(step);
      const auto visited = std::ranges::find(path, to);
      if (visited != path.end()) {  // a loop is closed; walk on from where it began
        loops.emplace_back(visited, path.end());
        path.erase(visited, path.end());
      }
      path.push_back(to);
    }
  }
  return loops;
}

/// The loop's corners on a fine grid in its own plane; none if they stray from it.
std::optional<std::vector<GridPoint>> flattened(const Mesh& mesh, const Loop& loop,
                                                double tolerance) {
  glm::dvec3 normal{0.0};
  glm::dvec3 middle{0.0};
  const glm::dvec3 first = mesh.positions[loop.front()];
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const glm::dvec3 p = mesh.positions[loop[i]];
    normal += glm::cross(p - first, mesh.positions[loop[(i + 1) % loop.size()]] - first);
    middle += p / static_cast<double>(loop.size());
  }
  if (!(glm::length(normal) > 0.0)) {
    return std::nullopt;
  }
  normal = glm::normalize(normal);
  double radius = 0.0;
  for (const std::uint32_t i : loop) {
    const glm::dvec3 arm = mesh.positions[i] - middle;
    if (std::abs(glm::dot(arm, normal)) > tolerance) {
      return std::nullopt;
    }
    radius = std::max(radius, glm::length(arm));
  }
  const glm::dvec3 other =
      std::abs(normal.x) < 0.7 ? glm::dvec3(1.0, 0.0, 0.0) : glm::dvec3(0.0, 1.0, 0.0);
  const glm::dvec3 u = glm::normalize(glm::cross(other, normal));
  const glm::dvec3 v = glm::cross(normal, u);
  constexpr double kGrid = 1 << 26;
  std::vector<GridPoint> points;
  for (const std::uint32_t i : loop) {
    const glm::dvec3 arm = (kGrid / radius) * (mesh.positions[i] - middle);
    points.emplace_back(std::llround(glm::dot(arm, u)), std::llround(glm::dot(arm, v)));
  }
  return points;
}

}  // namespace

FilledHoles fill_planar_holes(Mesh& mesh, double tolerance) {
  FilledHoles filled;
  for (const Loop& loop : hole_loops(mesh)) {
    if (loop.size() < 3) {
      continue;
    }
    const auto points = flattened(mesh, loop, tolerance);
    if (!points) {
      continue;
    }
    Loop contour(loop.size());
    std::iota(contour.begin(), contour.end(), 0U);
    const auto triangles = triangulate(*points, {contour});
    for (const auto& t : triangles) {
      mesh.triangles.push_back({loop[t[0]], loop[t[1]], loop[t[2]]});
    }
    filled.holes += triangles.empty() ? 0 : 1;
    filled.triangles += triangles.size();
  }
  return filled;
}

}  // namespace wedgesim::functional
