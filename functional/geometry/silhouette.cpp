#include "functional/geometry/silhouette.h"

#include <algorithm>
#include <glm/geometric.hpp>
#include <unordered_map>
#include <utility>

#include "base/check.h"

namespace wedgesim::functional {
namespace {

// Edges of light-facing triangles whose other side does not face the light: what is left when the
// two directions of an edge inside the light-facing region cancel.
std::vector<SilhouetteEdge> boundary_of(const Mesh& mesh, const std::vector<bool>& light_facing) {
  struct Directed {
    std::uint64_t undirected;
    std::uint32_t begin, end;
  };
  std::vector<Directed> edges;
  for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
    if (!light_facing[t]) continue;
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i];
      const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
      edges.push_back({(std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b), a, b});
    }
  }
  std::sort(edges.begin(), edges.end(), [](const Directed& a, const Directed& b) {
    return a.undirected != b.undirected ? a.undirected < b.undirected : a.begin < b.begin;
  });
  std::vector<SilhouetteEdge> boundary;
  for (std::size_t i = 0; i < edges.size();) {
    if (i + 1 < edges.size() && edges[i].undirected == edges[i + 1].undirected) {
      i += 2;
    } else {
      boundary.push_back({edges[i].begin, edges[i].end});
      ++i;
    }
  }
  return boundary;
}

}  // namespace

Silhouette find_silhouette(const Mesh& mesh, const glm::dvec3& from) {
  std::vector<bool> light_facing;
  light_facing.reserve(mesh.triangles.size());
  for (const auto& corner : mesh.triangles) {
    const glm::dvec3& p = mesh.positions[corner[0]];
    const glm::dvec3 normal =
        glm::cross(mesh.positions[corner[1]] - p, mesh.positions[corner[2]] - p);
    light_facing.push_back(glm::dot(normal, from - p) > 0.0);
  }
  return find_outline(mesh, std::move(light_facing));
}

Silhouette find_outline(const Mesh& mesh, std::vector<bool> inside) {
  Silhouette silhouette;
  silhouette.light_facing = std::move(inside);
  const std::vector<SilhouetteEdge> edges = boundary_of(mesh, silhouette.light_facing);
  std::unordered_multimap<std::uint32_t, std::size_t> leaving;  // by begin vertex
  for (std::size_t i = edges.size(); i-- > 0;) leaving.emplace(edges[i].begin, i);
  std::vector<bool> used(edges.size(), false);
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    std::vector<SilhouetteEdge> loop;
    std::size_t at = start;
    while (!used[at]) {
      used[at] = true;
      loop.push_back(edges[at]);
      // The lowest unused edge that leaves this end; none is left when the loop closes.
      std::size_t next = edges.size();
      const auto [first, last] = leaving.equal_range(edges[at].end);
      for (auto it = first; it != last; ++it) {
        if (!used[it->second]) next = std::min(next, it->second);
      }
      if (next == edges.size()) break;
      if (edges[at].end == loop.front().begin) break;  // closed at a vertex of higher degree
      at = next;
    }
    CHECK_EQ(loop.back().end, loop.front().begin);
    silhouette.loops.push_back(std::move(loop));
  }
  return silhouette;
}

}  // namespace wedgesim::functional
