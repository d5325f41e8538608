#include "functional/geometry/loop_groups.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>

#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

struct Outline {
  std::vector<glm::dvec2> points;
  double area = 0.0;  // positive around a shadow
};

// Whether the ray from a point along x crosses the outline an odd number of times.
bool holds(const Outline& outline, const glm::dvec2& p) {
  bool inside = false;
  for (std::size_t i = 0; i < outline.points.size(); ++i) {
    const glm::dvec2& a = outline.points[i];
    const glm::dvec2& b = outline.points[(i + 1) % outline.points.size()];
    if ((a.y > p.y) == (b.y > p.y)) continue;
    if (p.x < a.x + (p.y - a.y) / (b.y - a.y) * (b.x - a.x)) inside = !inside;
  }
  return inside;
}

}  // namespace

std::vector<std::uint32_t> loop_groups(const Mesh& mesh, const Silhouette& silhouette,
                                       const glm::dvec3& light_centre) {
  glm::dvec3 sum(0.0);
  for (const auto& loop : silhouette.loops) {
    for (const SilhouetteEdge& edge : loop) {
      sum += glm::normalize(mesh.positions[edge.begin] - light_centre);
    }
  }
  // Seen from the light: a loop around a shadow has the caster on its left, so it runs
  // counter-clockwise for who looks along the axis with u to the right and v up: u x v = -axis.
  const glm::dvec3 axis = glm::normalize(sum);
  const Across across(-axis);
  std::vector<Outline> outlines;
  for (const auto& loop : silhouette.loops) {
    Outline& outline = outlines.emplace_back();
    for (const SilhouetteEdge& edge : loop) {
      const glm::dvec3 d = mesh.positions[edge.begin] - light_centre;
      outline.points.push_back(glm::dvec2(glm::dot(d, across.u), glm::dot(d, across.v)) /
                               glm::dot(d, axis));
    }
    for (std::size_t i = 0; i < outline.points.size(); ++i) {
      const glm::dvec2& a = outline.points[i];
      const glm::dvec2& b = outline.points[(i + 1) % outline.points.size()];
      outline.area += 0.5 * (a.x * b.y - b.x * a.y);
    }
  }
  std::vector<std::uint32_t> groups(outlines.size(), 0);
  std::uint32_t count = 0;
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (outlines[i].area > 0.0) groups[i] = count++;
  }
  for (std::size_t i = 0; i < outlines.size(); ++i) {
    if (outlines[i].area > 0.0) continue;
    const Outline* around = nullptr;
    for (std::size_t k = 0; k < outlines.size(); ++k) {
      const Outline& outer = outlines[k];
      if (outer.area <= 0.0 || (around != nullptr && outer.area >= around->area)) continue;
      if (!holds(outer, outlines[i].points.front())) continue;
      around = &outer;
      groups[i] = groups[k];
    }
  }
  return groups;
}

}  // namespace wedgesim::functional
