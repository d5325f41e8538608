#include "functional/geometry/loose_wedge.h"

#include <gtest/gtest.h>

#include "tests/functional/geometry/closed_surface.h"
#include "tests/functional/geometry/penumbra.h"

namespace wedgesim::functional {
namespace {

double value(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

class LooseWedge : public testing::TestWithParam<LightShape> {};
INSTANTIATE_TEST_SUITE_P(Lights, LooseWedge,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

// Does it hold every point from which the edge covers a part of the light, and more than the tight
// one?
TEST_P(LooseWedge, HoldsThePenumbraAndMore) {
  Random random(207);
  int made = 0;
  int more = 0;
  int points = 0;
  for (int i = 0; i < 4000; ++i) {
    const EdgeCase edge = random_edge(random, GetParam());
    const auto loose = loose_wedge(edge.light, edge.begin, edge.end, edge.end_plane);
    if (!loose) continue;
    ++made;
    const double size = glm::distance(edge.begin, edge.light.centre);
    const WorldWedge tight = coverage_wedge(edge.light, edge.begin, edge.end, edge.end_plane);
    for (int k = 0; k < 20; ++k) {
      const glm::dvec3 p = penumbra_point(random, edge);
      for (const glm::dvec4& plane : loose->planes) {
        ASSERT_GT(value(plane, p), -1e-7 * size) << "case " << i << ": " << edge;
      }
    }
    for (const WedgeFace& face : loose->faces) {
      for (const std::uint32_t corner : face.corners) {
        EXPECT_NEAR(value(loose->planes[face.plane], loose->vertices[corner]), 0.0, 1e-6 * size);
        ++points;
        for (const glm::dvec4& plane : tight.planes) {
          if (value(plane, loose->vertices[corner]) < -1e-6 * size) {
            ++more;
            break;
          }
        }
      }
    }
  }
  std::cout << made << " wedges, " << more << " of " << points << " corners beyond the tight one\n";
  EXPECT_GT(made, 2000);
  EXPECT_GT(more, points / 4);
}

}  // namespace
}  // namespace wedgesim::functional
