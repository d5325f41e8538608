#include "functional/geometry/loop_groups.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <set>

#include "functional/scene/primitives.h"

namespace wedgesim::functional {
namespace {

void add(Mesh& mesh, const Mesh& part, const glm::dvec3& at) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3& p : part.positions) mesh.positions.push_back(p + at);
  for (auto t : part.triangles) {
    for (std::uint32_t& corner : t) corner += first;
    mesh.triangles.push_back(t);
  }
}

// A ring shadows with its hole; what lies in the hole is a shadow of its own.
TEST(LoopGroups, AHoleGoesWithTheLoopAroundIt) {
  const glm::dvec3 light(0.03, 20.0, 0.01);
  Mesh mesh;
  add(mesh, make_torus(2.0, 0.4, 24, 12), {0.0, 0.0, 0.0});
  add(mesh, make_sphere(0.5, 12, 8), {0.1, 0.0, 0.0});
  add(mesh, make_torus(1.0, 0.2, 24, 12), {6.0, 0.0, 1.0});
  const Silhouette silhouette = find_silhouette(mesh, light);
  ASSERT_EQ(silhouette.loops.size(), 5U);
  const std::vector<std::uint32_t> groups = loop_groups(mesh, silhouette, light);
  // By the middle of each loop and how far it reaches.
  std::multiset<std::uint32_t> around_far;
  std::multiset<std::uint32_t> around_near;
  std::uint32_t sphere = 99;
  for (std::size_t i = 0; i < groups.size(); ++i) {
    const glm::dvec3& p = mesh.positions[silhouette.loops[i].front().begin];
    if (p.x > 3.5) {
      around_far.insert(groups[i]);
    } else if (p.x * p.x + p.z * p.z > 1.0) {
      around_near.insert(groups[i]);
    } else {
      sphere = groups[i];
    }
  }
  ASSERT_EQ(around_far.size(), 2U);
  ASSERT_EQ(around_near.size(), 2U);
  EXPECT_EQ(*around_far.begin(), *around_far.rbegin());
  EXPECT_EQ(*around_near.begin(), *around_near.rbegin());
  EXPECT_EQ((std::set<std::uint32_t>{*around_far.begin(), *around_near.begin(), sphere}),
            (std::set<std::uint32_t>{0, 1, 2}));
}

}  // namespace
}  // namespace wedgesim::functional
