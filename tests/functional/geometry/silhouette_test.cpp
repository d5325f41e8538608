#include "functional/geometry/silhouette.h"

#include <gtest/gtest.h>

#include <map>
#include <set>

#include "functional/scene/primitives.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

using DirectedEdge = std::pair<std::uint32_t, std::uint32_t>;

// The silhouette by its definition: each edge of two triangles of which one faces the point, in
// the direction of that triangle.
std::multiset<DirectedEdge> edges_by_definition(const Mesh& mesh, const glm::dvec3& from) {
  std::map<DirectedEdge, bool> facing;
  for (const auto& t : mesh.triangles) {
    const glm::dvec3& a = mesh.positions[t[0]];
    const glm::dvec3 normal = glm::cross(mesh.positions[t[1]] - a, mesh.positions[t[2]] - a);
    for (std::size_t i = 0; i < 3; ++i) {
      facing[{t[i], t[(i + 1) % 3]}] = glm::dot(normal, from - a) > 0.0;
    }
  }
  std::multiset<DirectedEdge> edges;
  for (const auto& [edge, lit] : facing) {
    if (lit && !facing.at({edge.second, edge.first})) edges.insert(edge);
  }
  return edges;
}

// Checks a silhouette; returns the highest degree of its vertices.
int check(const Mesh& mesh, const glm::dvec3& from) {
  const Silhouette silhouette = find_silhouette(mesh, from);
  EXPECT_EQ(silhouette.light_facing.size(), mesh.triangles.size());
  std::multiset<DirectedEdge> edges;
  std::map<std::uint32_t, int> degree;
  for (const auto& loop : silhouette.loops) {
    EXPECT_GE(loop.size(), 3U);
    for (std::size_t i = 0; i < loop.size(); ++i) {
      EXPECT_EQ(loop[i].end, loop[(i + 1) % loop.size()].begin) << "not closed";
      edges.insert({loop[i].begin, loop[i].end});
      ++degree[loop[i].begin];
      ++degree[loop[i].end];
    }
  }
  EXPECT_EQ(edges, edges_by_definition(mesh, from));
  int highest = 0;
  for (const auto& [vertex, count] : degree) {
    EXPECT_EQ(count % 2, 0) << "vertex " << vertex;
    highest = std::max(highest, count);
  }
  return highest;
}

glm::dvec3 outside(Random& random, double least) {
  return random.uniform(least, 4.0 * least) * random.direction();
}

// A box seen from above a corner: six edges around three lit faces, the lit side on the left.
TEST(Silhouette, BoxFromAbove) {
  const Mesh box = make_box({2.0, 2.0, 2.0});
  EXPECT_EQ(check(box, {10.0, 12.0, 11.0}), 2);
  const Silhouette corner = find_silhouette(box, {10.0, 12.0, 11.0});
  ASSERT_EQ(corner.loops.size(), 1U);
  EXPECT_EQ(corner.loops[0].size(), 6U);

  const glm::dvec3 above(0.0, 9.0, 0.0);
  const Silhouette top = find_silhouette(box, above);
  ASSERT_EQ(top.loops.size(), 1U);
  ASSERT_EQ(top.loops[0].size(), 4U);
  for (const SilhouetteEdge& edge : top.loops[0]) {
    const glm::dvec3& a = box.positions[edge.begin];
    const glm::dvec3& b = box.positions[edge.end];
    EXPECT_GT(glm::dot(glm::cross(a - above, b - above), glm::dvec3(0, 1, 0)), 0.0)
        << "counter-clockwise seen from the light";
  }
}

// A point in a face's plane is not in front of it.
TEST(Silhouette, FacesEdgeOnAreDark) {
  const Mesh box = make_box({2.0, 2.0, 2.0});
  const Silhouette silhouette = find_silhouette(box, {1.0, 5.0, 0.0});
  int lit = 0;
  for (const bool facing : silhouette.light_facing) lit += facing ? 1 : 0;
  EXPECT_EQ(lit, 2);
  EXPECT_EQ(check(box, {1.0, 5.0, 0.0}), 2);
}

TEST(Silhouette, SpheresAndTori) {
  Random random(71);
  const Mesh sphere = make_sphere(1.0, 16, 9);
  const Mesh torus = make_torus(1.0, 0.35, 24, 12);
  for (int i = 0; i < 200; ++i) {
    check(sphere, outside(random, 1.2));
    check(torus, outside(random, 1.5));
  }
  // Through the hole: an outer and an inner loop.
  EXPECT_EQ(find_silhouette(torus, {0.03, 20.0, 0.01}).loops.size(), 2U);
  EXPECT_TRUE(find_silhouette(sphere, glm::dvec3(0.0)).loops.empty()) << "from inside";
}

// Two tetrahedra that touch at a vertex: there the silhouettes of both meet.
TEST(Silhouette, VertexOfDegreeFour) {
  Mesh mesh;
  mesh.positions = {{0, 0, 0},   {2, -1, 0}, {2, 1, -1}, {2, 1, 1},
                    {-2, -1, 0}, {-2, 1, 1}, {-2, 1, -1}};
  const auto add = [&](std::uint32_t a, std::uint32_t b, std::uint32_t c, std::uint32_t d) {
    mesh.triangles.insert(mesh.triangles.end(), {{a, b, c}, {a, c, d}, {a, d, b}, {b, d, c}});
  };
  add(0, 1, 3, 2);
  add(0, 4, 6, 5);
  EXPECT_EQ(check(mesh, {0.3, 0.5, 30.0}), 4);
  EXPECT_EQ(find_silhouette(mesh, {0.3, 0.5, 30.0}).loops.size(), 2U);
}

// Crumpled spheres have vertices of degree four and more on an unbroken surface (Paper V).
TEST(Silhouette, CrumpledSpheres) {
  Random random(72);
  int crossings = 0;
  for (int i = 0; i < 300; ++i) {
    Mesh mesh = make_sphere(1.0, 14, 10);
    for (glm::dvec3& p : mesh.positions) p *= random.uniform(0.5, 1.5);
    if (check(mesh, outside(random, 1.6)) > 2) ++crossings;
  }
  EXPECT_GT(crossings, 100);
}

}  // namespace
}  // namespace wedgesim::functional
