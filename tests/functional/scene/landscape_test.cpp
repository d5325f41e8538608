#include "functional/scene/landscape.h"

#include <gtest/gtest.h>

#include "functional/scene/teapot.h"
#include "functional/scene/transform.h"
#include "tests/functional/scene/mesh_facts.h"

namespace wedgesim::functional {
namespace {

TEST(Landscape, HasTheTrianglesOfThePaperAndFacesUp) {
  const Mesh land = make_landscape({});
  EXPECT_EQ(land.triangles.size(), 100352U);
  for (const auto& t : land.triangles) {
    const glm::dvec3 a = land.positions[t[0]];
    ASSERT_GT(glm::cross(land.positions[t[1]] - a, land.positions[t[2]] - a).y, 0.0);
  }
  const auto [low, high] = bounds_of(land);
  EXPECT_DOUBLE_EQ(low.y, 0.0);
  EXPECT_DOUBLE_EQ(high.y, 2.0);
  EXPECT_EQ(examine(land).boundary_edges, 4U * 224U);
}

TEST(Landscape, SeedDecidesTheShape) {
  LandscapeStyle other;
  other.seed = 2;
  EXPECT_EQ(make_landscape({}).positions, make_landscape({}).positions);
  EXPECT_NE(make_landscape({}).positions, make_landscape(other).positions);
}

TEST(Landscape, MoreOctavesAreRougher) {
  const auto roughness = [](int octaves) {
    LandscapeStyle style;
    style.octaves = octaves;
    const Mesh land = make_landscape(style);
    double sum = 0.0;
    for (std::size_t i = 1; i + 1 < land.positions.size(); ++i) {
      sum +=
          std::abs(land.positions[i - 1].y - 2.0 * land.positions[i].y + land.positions[i + 1].y);
    }
    return sum;
  };
  EXPECT_GT(roughness(7), 2.0 * roughness(2));
}

TEST(Teapot, IsFourClosedSurfacesOfTheRightHeight) {
  const Mesh pot = welded(make_teapot(1.5, 32));
  EXPECT_GT(sound_volume(pot), 0.5);
  EXPECT_EQ(euler_number(pot), 4 * 2);
  const auto [low, high] = bounds_of(pot);
  EXPECT_DOUBLE_EQ(low.y, 0.0);
  EXPECT_DOUBLE_EQ(high.y, 1.5);
  EXPECT_GT(high.x, -low.x - 0.5);
}

}  // namespace
}  // namespace wedgesim::functional
