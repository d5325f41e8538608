#include "functional/scene/transform.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "functional/scene/primitives.h"
#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

glm::dvec3 moved(glm::dvec3 p, const Placement& placement) {
  Mesh mesh;
  mesh.positions = {p};
  return placed(mesh, placement).positions.front();
}

TEST(Transform, QuarterTurnsAreRightHandedAndExact) {
  const auto turned = [](glm::dvec3 p, glm::dvec3 degrees) {
    return moved(p, {.turn_degrees = degrees});
  };
  EXPECT_EQ(turned({0, 1, 0}, {90, 0, 0}), glm::dvec3(0, 0, 1));
  EXPECT_EQ(turned({0, 0, 1}, {0, 90, 0}), glm::dvec3(1, 0, 0));
  EXPECT_EQ(turned({1, 0, 0}, {0, 0, 90}), glm::dvec3(0, 1, 0));
  EXPECT_EQ(turned({1, 2, 3}, {0, -270, 0}), glm::dvec3(3, 2, -1));
  EXPECT_EQ(turned({1, 2, 3}, {0, 180, 0}), glm::dvec3(-1, 2, -3));
}

TEST(Transform, OtherTurnsKeepLengthAndHandedness) {
  const glm::dvec3 p = moved({1, 0, 0}, {.turn_degrees = {0, 30, 0}});
  EXPECT_NEAR(p.x, std::sqrt(0.75), 1e-15);
  EXPECT_NEAR(p.z, -0.5, 1e-15);
  const Mesh box = placed(make_box({1, 2, 3}), {.scale = {2, 1, 1}, .turn_degrees = {10, 20, 30}});
  EXPECT_NEAR(sound_volume(box), 12.0, 1e-12);
}

TEST(Transform, ScalesThenTurnsAboutXYZThenMoves) {
  const Placement placement{{2, 3, 4}, {90, 90, 0}, {10, 0, 0}};
  // (0, 3, 0) after scaling; about x to (0, 0, 3); about y to (3, 0, 0).
  EXPECT_EQ(moved({0, 1, 0}, placement), glm::dvec3(13, 0, 0));
}

TEST(Transform, FittedStandsOnTheGround) {
  const auto [low, high] =
      bounds_of(fitted(placed(make_box({2, 4, 1}), {.position = {7, 8, 9}}), 1.0));
  EXPECT_LT(glm::distance(low, glm::dvec3(-0.25, 0.0, -0.125)), 1e-15);
  EXPECT_LT(glm::distance(high, glm::dvec3(0.25, 1.0, 0.125)), 1e-15);
}

TEST(Transform, APointCannotBeFitted) {
  Mesh point;
  point.name = "dot";
  point.positions = {{1, 1, 1}};
  EXPECT_EQ(input_error_of([&] { fitted(point, 1.0); }),
            "dot: the mesh has no extent; expected a mesh larger than a point");
}

}  // namespace
}  // namespace wedgesim::functional
