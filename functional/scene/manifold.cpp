#include "functional/scene/manifold.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <tuple>
#include <vector>

#include "base/error.h"
#include "functional/scene/transform.h"

namespace wedgesim::functional {
namespace {

/// One triangle's use of an edge.
struct Use {
  std::uint32_t low;
  std::uint32_t high;
  std::uint32_t triangle;
  bool forward;  // from low to high
};

std::vector<Use> edge_uses(const Mesh& mesh) {
  std::vector<Use> uses;
  uses.reserve(3 * mesh.triangles.size());
  for (std::uint32_t i = 0; i < mesh.triangles.size(); ++i) {
    const auto& t = mesh.triangles[i];
    for (std::size_t k = 0; k < 3; ++k) {
      const std::uint32_t from = t[k];
      const std::uint32_t to = t[(k + 1) % 3];
      uses.push_back({std::min(from, to), std::max(from, to), i, from < to});
    }
  }
  std::ranges::sort(uses, [](const Use& a, const Use& b) {
    return std::tie(a.low, a.high, a.triangle) < std::tie(b.low, b.high, b.triangle);
  });
  return uses;
}

/// No triangle is wider than a millionth of its length: below the precision of a mesh file.
bool has_no_area(const Mesh& mesh) {
  return std::ranges::all_of(mesh.triangles, [&mesh](const auto& t) {
    const glm::dvec3 ab = mesh.positions[t[1]] - mesh.positions[t[0]];
    const glm::dvec3 ac = mesh.positions[t[2]] - mesh.positions[t[0]];
    const glm::dvec3 bc = ac - ab;
    const double longest = std::max({glm::dot(ab, ab), glm::dot(ac, ac), glm::dot(bc, bc)});
    return glm::length(glm::cross(ab, ac)) <= 1e-6 * longest;
  });
}

/// A sheet of no volume is not inside out, whatever its rounding.
bool is_inside_out(const Mesh& mesh) {
  const auto [low, high] = bounds_of(mesh);
  const double diagonal = glm::distance(low, high);
  return signed_volume(mesh) < -1e-9 * diagonal * diagonal * diagonal;
}

}  // namespace

ManifoldReport examine(const Mesh& mesh) {
  ManifoldReport report;
  const std::vector<Use> uses = edge_uses(mesh);
  std::uint32_t first_triangle = 0;
  for (std::size_t begin = 0, end = 0; begin < uses.size(); begin = end) {
    const Use& use = uses[begin];
    while (end < uses.size() && uses[end].low == use.low && uses[end].high == use.high) {
      ++end;
    }
    const std::size_t count = end - begin;
    if (count == 2 && use.low != use.high && use.forward != uses[begin + 1].forward) {
      continue;
    }
    (count == 1   ? report.boundary_edges
     : count == 2 ? report.inconsistent_edges
                  : report.non_manifold_edges) += 1;
    if (!report.first_bad || use.triangle < first_triangle) {
      report.first_bad = 0.5 * (mesh.positions[use.low] + mesh.positions[use.high]);
      first_triangle = use.triangle;
    }
  }
  return report;
}

double signed_volume(const Mesh& mesh) {
  double six_volumes = 0.0;
  const glm::dvec3 origin = mesh.positions.empty() ? glm::dvec3(0.0) : mesh.positions.front();
  for (const auto& t : mesh.triangles) {
    const glm::dvec3 a = mesh.positions[t[0]] - origin;
    six_volumes +=
        glm::dot(a, glm::cross(mesh.positions[t[1]] - origin, mesh.positions[t[2]] - origin));
  }
  return six_volumes / 6.0;
}

bool is_sound(const Mesh& mesh) { return examine(mesh).closed() && !is_inside_out(mesh); }

void require_closed(const Mesh& mesh, const std::string& place, const std::string& remark) {
  if (has_no_area(mesh)) {
    throw InputError(place, fmt::format("mesh '{}' has no area{}", mesh.name, remark),
                     "a triangle whose corners are not on one line");
  }
  const ManifoldReport report = examine(mesh);
  if (!report.closed()) {
    const glm::dvec3 at = *report.first_bad;
    throw InputError(
        place,
        fmt::format("mesh '{}' is not closed{}: {} boundary, {} non-manifold and {} inconsistently "
                    "oriented edges, the first at ({:g}, {:g}, {:g})",
                    mesh.name, remark, report.boundary_edges, report.non_manifold_edges,
                    report.inconsistent_edges, at.x, at.y, at.z),
        "a closed two-manifold");
  }
  if (is_inside_out(mesh)) {
    throw InputError(place, fmt::format("mesh '{}' is inside out{}", mesh.name, remark),
                     "triangles counter-clockwise seen from outside");
  }
}

}  // namespace wedgesim::functional
