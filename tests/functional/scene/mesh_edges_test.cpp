#include "functional/scene/mesh_edges.h"

#include <gtest/gtest.h>

#include <tuple>

#include "functional/scene/primitives.h"

namespace wedgesim::functional {
namespace {

bool runs(const Mesh& mesh, std::uint32_t triangle, std::uint32_t from, std::uint32_t to) {
  const auto& t = mesh.triangles.at(triangle);
  for (std::size_t i = 0; i < 3; ++i) {
    if (t[i] == from && t[(i + 1) % 3] == to) return true;
  }
  return false;
}

// Euler's formula, and each edge between its two triangles.
TEST(MeshEdges, OfClosedMeshes) {
  for (const Mesh& mesh : {make_box({1, 2, 3}), make_torus(2.0, 0.5, 9, 7), make_sphere(1.0, 8, 5),
                           make_thin_polygon({{0, 0}, {0, 2}, {2, 2}, {2, 0}})}) {
    const std::vector<MeshEdge> edges = mesh_edges(mesh);
    ASSERT_EQ(2 * edges.size(), 3 * mesh.triangles.size());
    for (std::size_t i = 0; i < edges.size(); ++i) {
      const MeshEdge& edge = edges[i];
      EXPECT_LT(edge.low, edge.high);
      EXPECT_TRUE(runs(mesh, edge.forward, edge.low, edge.high));
      EXPECT_TRUE(runs(mesh, edge.backward, edge.high, edge.low));
      if (i > 0) {
        EXPECT_LT(std::tie(edges[i - 1].low, edges[i - 1].high), std::tie(edge.low, edge.high));
      }
    }
  }
}

TEST(MeshEdges, AtABorderHaveOneTriangle) {
  const std::vector<MeshEdge> edges = mesh_edges(make_plane({1, 1}, {1, 1}));
  ASSERT_EQ(edges.size(), 5U);
  int alone = 0;
  for (const MeshEdge& edge : edges) {
    alone += edge.forward == MeshEdge::kNone || edge.backward == MeshEdge::kNone ? 1 : 0;
  }
  EXPECT_EQ(alone, 4);
}

}  // namespace
}  // namespace wedgesim::functional
