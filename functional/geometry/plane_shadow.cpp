#include "functional/geometry/plane_shadow.h"

#include <fmt/format.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <limits>

#include "base/check.h"
#include "base/error.h"
#include "functional/geometry/sweep_line.h"

namespace wedgesim::functional {
namespace {

// Heights of lights over casters, as a part of the light's: nearer, shadows have no end.
constexpr double kClearance = 1e-3;

glm::dvec2 project(const glm::dvec3& light, const glm::dvec3& p) {
  const double t = light.z / (light.z - p.z);
  return {light.x + t * (p.x - light.x), light.y + t * (p.y - light.y)};
}

// Where an edge meets the plane; the same from both of its triangles.
glm::dvec2 foot(const glm::dvec3& a, const glm::dvec3& b) {
  const double t = a.z / (a.z - b.z);
  return {a.x + t * (b.x - a.x), a.y + t * (b.y - a.y)};
}

}  // namespace

PlaneShadow::PlaneShadow(const Scene& scene, ReceiverPlane& plane,
                         std::span<const glm::dvec3> lights)
    : plane_(plane) {
  glm::dvec3 low(1e300);
  glm::dvec3 high(-1e300);
  double lowest_light = 1e300;
  for (const glm::dvec3& light : lights) {
    lowest_light = std::min(lowest_light, plane.from_world(light).z);
  }
  if (!(lowest_light > 0.0)) {
    throw InputError(scene.place, "the plane of the receivers meets the light",
                     "the light on one side of it");
  }
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    const std::size_t first = positions_.size();
    add(object.mesh);
    for (std::size_t i = first; i < positions_.size(); ++i) {
      low = glm::min(low, positions_[i]);
      high = glm::max(high, positions_[i]);
    }
    if (high.z > (1.0 - kClearance) * lowest_light) {
      throw InputError(
          scene.place,
          fmt::format("'{}' reaches the height of the light over the receivers", object.mesh.name),
          "casters between light and receivers");
    }
  }
  // The shadow of the casters' box holds their shadows.
  double longest = 1e-300;
  for (const glm::dvec3& light : lights) {
    const glm::dvec3 from = plane.from_world(light);
    for (int corner = 0; corner < 8 && !positions_.empty(); ++corner) {
      const glm::dvec3 p((corner & 1) != 0 ? high.x : low.x, (corner & 2) != 0 ? high.y : low.y,
                         (corner & 4) != 0 ? std::max(high.z, 0.0) : 0.0);
      const glm::dvec2 end = project(from, p);
      longest = std::max({longest, std::abs(end.x), std::abs(end.y)});
    }
  }
  plane.unit = longest / (kGridLimit - 16);
}

void PlaneShadow::add(const Mesh& mesh) {
  const auto first_vertex = static_cast<std::uint32_t>(positions_.size());
  const auto first_triangle = static_cast<std::uint32_t>(triangles_.size());
  for (const glm::dvec3& p : mesh.positions) positions_.push_back(plane_.from_world(p));
  for (const auto& t : mesh.triangles) {
    const auto triangle = static_cast<std::uint32_t>(triangles_.size());
    triangles_.push_back({first_vertex + t[0], first_vertex + t[1], first_vertex + t[2]});
    const glm::dvec3& a = positions_[triangles_.back()[0]];
    faces_.push_back({a, glm::cross(positions_[triangles_.back()[1]] - a,
                                    positions_[triangles_.back()[2]] - a)});
    int above = 0;
    for (const std::uint32_t v : triangles_.back()) above += positions_[v].z > 0.0 ? 1 : 0;
    if (above == 1 || above == 2) crossing_.push_back(triangle);
  }
  // Both directions of an edge meet in the list of its lesser vertex.
  struct Half {
    std::uint32_t other, triangle;
    bool up;  // from the lesser vertex
  };
  std::vector<std::uint32_t> next(mesh.positions.size() + 1, 0);
  const auto for_each_half = [&](auto&& visit) {
    for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
      for (std::size_t i = 0; i < 3; ++i) {
        visit(mesh.triangles[t][i], mesh.triangles[t][(i + 1) % 3], first_triangle + t);
      }
    }
  };
  for_each_half(
      [&](std::uint32_t a, std::uint32_t b, std::uint32_t) { ++next[std::min(a, b) + 1]; });
  for (std::size_t i = 1; i < next.size(); ++i) next[i] += next[i - 1];
  std::vector<Half> halves(next.back());
  std::vector<std::uint32_t> fill(next.begin(), next.end() - 1);
  for_each_half([&](std::uint32_t a, std::uint32_t b, std::uint32_t triangle) {
    halves[fill[std::min(a, b)]++] = {std::max(a, b), triangle, a < b};
  });
  for (std::uint32_t v = 0; v < mesh.positions.size(); ++v) {
    const auto begin = halves.begin() + next[v];
    const auto end = halves.begin() + next[v + 1];
    std::sort(begin, end, [](const Half& a, const Half& b) {
      return a.other != b.other ? a.other < b.other : a.up > b.up;
    });
    for (auto half = begin; half != end; half += 2) {
      WEDGESIM_CHECK(half + 1 != end && (half + 1)->other == half->other && half->up &&
                     !(half + 1)->up);
      edges_.push_back(
          {first_vertex + v, first_vertex + half->other, half->triangle, (half + 1)->triangle});
    }
  }
}

std::vector<GridSegment> PlaneShadow::loops(const glm::dvec3& light) const {
  const glm::dvec3 from = plane_.from_world(light);
  std::vector<char> lit(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    lit[t] = glm::dot(faces_[t].normal, from - faces_[t].point) > 0.0 ? 1 : 0;
  }
  std::vector<GridSegment> segments;
  const auto add = [&](const glm::dvec2& begin, const glm::dvec2& end) {
    const GridSegment segment{plane_.vertex(begin), plane_.vertex(end), 1};
    if (segment.begin != segment.end) segments.push_back(segment);
  };
  for (const Edge& edge : edges_) {
    if (lit[edge.left] == lit[edge.right]) continue;
    const glm::dvec3& a = positions_[edge.begin];
    const glm::dvec3& b = positions_[edge.end];
    if (a.z <= 0.0 && b.z <= 0.0) continue;
    glm::dvec2 begin = a.z > 0.0 ? project(from, a) : foot(a, b);
    glm::dvec2 end = b.z > 0.0 ? project(from, b) : foot(a, b);
    if (lit[edge.right] != 0) std::swap(begin, end);
    add(begin, end);
  }
  // Where the plane cuts a lit triangle, its part above ends: from the edge that goes down to the
  // edge that comes up.
  for (const std::uint32_t t : crossing_) {
    if (lit[t] == 0) continue;
    glm::dvec2 down;
    glm::dvec2 up;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t v = triangles_[t][i];
      const std::uint32_t w = triangles_[t][(i + 1) % 3];
      const bool above = positions_[v].z > 0.0;
      if (above == (positions_[w].z > 0.0)) continue;
      (above ? down : up) = foot(positions_[std::min(v, w)], positions_[std::max(v, w)]);
    }
    add(down, up);
  }
  return segments;
}

std::vector<GridSegment> PlaneShadow::silhouette(const glm::dvec3& light) const {
  return outline_of_union(loops(light));
}

std::vector<GridSegment> outline_of_union(std::span<const GridSegment> loops) {
  const Arrangement arrangement = arrange(loops);
  const Sweep sweep = sweep_line(arrangement, std::numeric_limits<int>::max());
  std::vector<GridSegment> outline;
  for (std::size_t i = 0; i < arrangement.edges.size(); ++i) {
    const auto& edge = arrangement.edges[i];
    const bool below = sweep.below[i] >= 1;
    const bool above = sweep.below[i] + edge.rise >= 1;
    if (below == above) continue;
    const GridPoint& a = arrangement.vertices[edge.begin];
    const GridPoint& b = arrangement.vertices[edge.end];
    outline.push_back(above ? GridSegment{a, b, 1} : GridSegment{b, a, 1});
  }
  return outline;
}

}  // namespace wedgesim::functional
