#include "functional/geometry/silhouette.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <glm/geometric.hpp>
#include <numeric>
#include <utility>

#include "base/check.h"
#include "functional/scene/mesh_edges.h"

namespace wedgesim::functional {
namespace {

constexpr std::size_t kChunk = 8192;  // triangles or edges that one task takes

// Calls body(begin, end, chunk) for all chunks of n items in parallel.
template <typename Body>
void for_each_chunk(std::size_t n, const Body& body) {
  tbb::parallel_for(std::size_t{0}, (n + kChunk - 1) / kChunk, [&](std::size_t chunk) {
    body(chunk * kChunk, std::min(n, (chunk + 1) * kChunk), chunk);
  });
}

std::vector<std::uint8_t> facing(const Mesh& mesh, const glm::dvec3& from) {
  std::vector<std::uint8_t> light_facing(mesh.triangles.size());
  for_each_chunk(light_facing.size(), [&](std::size_t begin, std::size_t end, std::size_t) {
    for (std::size_t t = begin; t < end; ++t) {
      const auto& corner = mesh.triangles[t];
      const glm::dvec3& p = mesh.positions[corner[0]];
      const glm::dvec3 normal =
          glm::cross(mesh.positions[corner[1]] - p, mesh.positions[corner[2]] - p);
      light_facing[t] = glm::dot(normal, from - p) > 0.0 ? 1 : 0;
    }
  });
  return light_facing;
}

// Edges of light-facing triangles whose other side does not face the light, in the edges' order.
std::vector<SilhouetteEdge> boundary_of(const std::vector<MeshEdge>& edges,
                                        const std::vector<std::uint8_t>& light_facing) {
  const auto faces = [&](std::uint32_t triangle) {
    return triangle != MeshEdge::kNone && light_facing[triangle] != 0;
  };
  std::vector<std::vector<SilhouetteEdge>> parts((edges.size() + kChunk - 1) / kChunk);
  for_each_chunk(edges.size(), [&](std::size_t begin, std::size_t end, std::size_t chunk) {
    for (std::size_t i = begin; i < end; ++i) {
      const MeshEdge& edge = edges[i];
      const bool forward = faces(edge.forward);
      if (forward == faces(edge.backward)) continue;
      parts[chunk].push_back(forward ? SilhouetteEdge{edge.low, edge.high}
                                     : SilhouetteEdge{edge.high, edge.low});
    }
  });
  std::vector<SilhouetteEdge> boundary;
  for (const auto& part : parts) boundary.insert(boundary.end(), part.begin(), part.end());
  return boundary;
}

// The edges that leave each vertex, in their order.
class Leaving {
 public:
  explicit Leaving(const std::vector<SilhouetteEdge>& edges) : edges_(edges), order_(edges.size()) {
    std::iota(order_.begin(), order_.end(), std::size_t{0});
    std::ranges::sort(order_, [&](std::size_t a, std::size_t b) {
      return edges[a].begin != edges[b].begin ? edges[a].begin < edges[b].begin : a < b;
    });
  }
  // The first unused one, or the number of edges.
  std::size_t first_unused(std::uint32_t vertex, const std::vector<bool>& used) const {
    auto at = std::ranges::lower_bound(order_, vertex, {},
                                       [&](std::size_t i) { return edges_[i].begin; });
    for (; at != order_.end() && edges_[*at].begin == vertex; ++at) {
      if (!used[*at]) return *at;
    }
    return edges_.size();
  }

 private:
  const std::vector<SilhouetteEdge>& edges_;
  std::vector<std::size_t> order_;
};

std::vector<std::vector<SilhouetteEdge>> loops_of(const std::vector<SilhouetteEdge>& edges) {
  const Leaving leaving(edges);
  std::vector<std::vector<SilhouetteEdge>> loops;
  std::vector<bool> used(edges.size(), false);
  for (std::size_t start = 0; start < edges.size(); ++start) {
    if (used[start]) continue;
    std::vector<SilhouetteEdge> loop;
    std::size_t at = start;
    while (!used[at]) {
      used[at] = true;
      loop.push_back(edges[at]);
      if (edges[at].end == loop.front().begin) break;  // closed, at a vertex of whatever degree
      const std::size_t next = leaving.first_unused(edges[at].end, used);
      if (next == edges.size()) break;
      at = next;
    }
    CHECK_EQ(loop.back().end, loop.front().begin);
    loops.push_back(std::move(loop));
  }
  return loops;
}

}  // namespace

Silhouette find_silhouette(const Mesh& mesh, const glm::dvec3& from) {
  return find_outline(mesh, facing(mesh, from));
}

Silhouette find_outline(const Mesh& mesh, std::vector<std::uint8_t> inside) {
  Silhouette silhouette;
  silhouette.light_facing = std::move(inside);
  silhouette.loops = loops_of(
      boundary_of(mesh.edges.empty() ? mesh_edges(mesh) : mesh.edges, silhouette.light_facing));
  return silhouette;
}

}  // namespace wedgesim::functional
