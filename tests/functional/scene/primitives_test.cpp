#include "functional/scene/primitives.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

constexpr double kPi = glm::pi<double>();

TEST(Primitives, BoxIsClosedAndStandsOnTheGround) {
  const Mesh box = make_box({2.0, 3.0, 4.0});
  EXPECT_EQ(box.positions.size(), 8U);
  EXPECT_EQ(box.triangles.size(), 12U);
  EXPECT_DOUBLE_EQ(sound_volume(box), 24.0);
  EXPECT_EQ(euler_number(box), 2);
  for (const glm::dvec3& p : box.positions) {
    EXPECT_TRUE(p.y == 0.0 || p.y == 3.0);
  }
}

TEST(Primitives, PlaneFacesUpAndIsOpen) {
  const Mesh plane = make_plane({4.0, 6.0}, {2, 3});
  EXPECT_EQ(plane.triangles.size(), 12U);
  EXPECT_EQ(examine(plane).boundary_edges, 10U);
  double area = 0.0;
  for (const auto& t : plane.triangles) {
    const glm::dvec3 a = plane.positions[t[0]];
    area += 0.5 * glm::cross(plane.positions[t[1]] - a, plane.positions[t[2]] - a).y;
  }
  EXPECT_DOUBLE_EQ(area, 24.0);
}

TEST(Primitives, SphereApproachesTheBall) {
  const Mesh sphere = make_sphere(1.5, 64, 32);
  EXPECT_NEAR(sound_volume(sphere), 4.0 / 3.0 * kPi * 1.5 * 1.5 * 1.5, 0.06);
  EXPECT_EQ(euler_number(sphere), 2);
}

TEST(Primitives, TorusHasOneHole) {
  const Mesh torus = make_torus(1.0, 0.3, 96, 48);
  EXPECT_NEAR(sound_volume(torus), 2.0 * kPi * kPi * 0.3 * 0.3, 0.01);
  EXPECT_EQ(euler_number(torus), 0);
}

TEST(Primitives, ThinPolygonIsTwoOppositeFacesWithOtherDiagonals) {
  for (int n = 4; n <= 9; ++n) {
    std::vector<glm::dvec2> points;
    for (int i = 0; i < n; ++i) {
      const double angle = 2.0 * kPi * i / n;
      points.emplace_back(std::cos(angle), -std::sin(angle));
    }
    const Mesh polygon = make_thin_polygon(points);
    EXPECT_TRUE(examine(polygon).closed()) << n;
    EXPECT_EQ(euler_number(polygon), 2) << n;
    EXPECT_EQ(polygon.positions.size(), static_cast<std::size_t>(n));
    EXPECT_NEAR(signed_volume(polygon), 0.0, 1e-15);
    double up = 0.0;
    double down = 0.0;
    for (const auto& t : polygon.triangles) {
      const glm::dvec3 a = polygon.positions[t[0]];
      const double y = glm::cross(polygon.positions[t[1]] - a, polygon.positions[t[2]] - a).y;
      (y > 0.0 ? up : down) += 0.5 * y;
    }
    EXPECT_NEAR(up, 0.5 * n * std::sin(2.0 * kPi / n), 1e-12);
    EXPECT_NEAR(up, -down, 1e-12);
  }
}

TEST(Primitives, ThinPolygonRejectsOtherOutlines) {
  const auto error = [](const std::vector<glm::dvec2>& points) {
    return input_error_of([&] { make_thin_polygon(points); });
  };
  const std::string expected =
      "; expected 4 or more points, convex, counter-clockwise seen from above";
  EXPECT_EQ(error({{0, 0}, {1, 0}, {0, 1}}), "points: there are 3" + expected);
  EXPECT_EQ(error({{0, 0}, {0, 1}, {1, 1}, {1, 0}}), "");
  EXPECT_EQ(error({{0, 0}, {1, 0}, {1, 1}, {0, 1}}),
            "points: point 2 is not left of edge 0" + expected);
  EXPECT_EQ(error({{0, 0}, {0, 1}, {0.1, 0.1}, {1, 0}}),
            "points: point 3 is not left of edge 1" + expected);
}

}  // namespace
}  // namespace wedgesim::functional
