#include "functional/scene/mesh_edges.h"

#include <algorithm>
#include <cstddef>

namespace wedgesim::functional {
namespace {

// One of a triangle's sides.
struct Side {
  std::uint64_t edge;  // lower vertex, higher vertex
  std::uint32_t triangle;
  bool forward;  // from the lower to the higher
};

std::vector<Side> sides_of(const Mesh& mesh) {
  std::vector<Side> sides;
  sides.reserve(3 * mesh.triangles.size());
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    for (std::size_t i = 0; i < 3; ++i) {
      const std::uint32_t a = mesh.triangles[t][i];
      const std::uint32_t b = mesh.triangles[t][(i + 1) % 3];
      sides.push_back({(std::uint64_t{std::min(a, b)} << 32U) | std::max(a, b), t, a < b});
    }
  }
  // Of one edge the forward sides first.
  std::ranges::sort(sides, [](const Side& a, const Side& b) {
    if (a.edge != b.edge) return a.edge < b.edge;
    return a.forward != b.forward ? a.forward : a.triangle < b.triangle;
  });
  return sides;
}

}  // namespace

std::vector<MeshEdge> mesh_edges(const Mesh& mesh) {
  const std::vector<Side> sides = sides_of(mesh);
  std::vector<MeshEdge> edges;
  edges.reserve(sides.size() / 2);
  for (std::size_t begin = 0, end = 0; begin < sides.size(); begin = end) {
    std::size_t backward = begin;
    while (end < sides.size() && sides[end].edge == sides[begin].edge) {
      backward += sides[end].forward ? 1 : 0;
      ++end;
    }
    const auto low = static_cast<std::uint32_t>(sides[begin].edge >> 32U);
    const auto high = static_cast<std::uint32_t>(sides[begin].edge);
    for (std::size_t i = 0; begin + i < backward || backward + i < end; ++i) {
      edges.push_back({low, high,
                       begin + i < backward ? sides[begin + i].triangle : MeshEdge::kNone,
                       backward + i < end ? sides[backward + i].triangle : MeshEdge::kNone});
    }
  }
  return edges;
}

}  // namespace wedgesim::functional
