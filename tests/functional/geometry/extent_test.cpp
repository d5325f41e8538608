#include "functional/geometry/extent.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

double value(const EndPlane& end, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(end.plane), p) + end.plane.w;
}

// A caster of four vertices whose silhouette is all of them, in any order: what counts here.
struct Case {
  Mesh caster;
  Silhouette silhouette;
  Light light;
  Bounds bounds;
};

Case random_case(Random& random) {
  Case c;
  for (int i = 0; i < 4; ++i) {
    c.caster.positions.push_back(random.in_box(glm::dvec3(-1.0, 1.0, -1.0), glm::dvec3(1, 2, 1)));
  }
  c.silhouette.loops = {{{0, 1}, {1, 2}, {2, 3}, {3, 0}}};
  c.light.centre = random.in_box(glm::dvec3(-6.0, 6.0, -6.0), glm::dvec3(6.0, 12.0, 6.0));
  if (random.chance(0.5)) {
    const glm::dvec3 way = glm::normalize(glm::dvec3(0.0, 1.5, 0.0) - c.light.centre);
    c.light.half_u = random.uniform(0.1, 0.8) * glm::normalize(glm::cross(way, {1, 0, 0.3}));
    c.light.half_v = random.uniform(0.1, 0.8) * glm::normalize(glm::cross(way, c.light.half_u));
  } else {
    c.light.shape = LightShape::sphere;
    c.light.radius = random.uniform(0.1, 0.8);
  }
  c.bounds.grow({-8.0, 0.0, -8.0});
  c.bounds.grow({8.0, 4.0, 8.0});
  return c;
}

// Is everything that receives in front of the end plane, and does every ray of the penumbra reach
// it behind the silhouette?
TEST(Extent, EveryRayEndsBeyondTheReceivers) {
  Random random(81);
  for (int i = 0; i < 2000; ++i) {
    const Case c = random_case(random);
    const EndPlane end = choose_end_plane(c.caster, c.silhouette, c.light, c.bounds, std::nullopt);
    ASSERT_NEAR(glm::length(glm::dvec3(end.plane)), 1.0, 1e-12);
    for (int k = 0; k < 8; ++k) {
      const glm::dvec3 corner((k & 1) != 0 ? 8.0 : -8.0, (k & 2) != 0 ? 4.0 : 0.0,
                              (k & 4) != 0 ? 8.0 : -8.0);
      ASSERT_GT(value(end, corner), 0.0) << "case " << i;
    }
    for (const glm::dvec3& v : c.caster.positions) {
      for (int k = 0; k < 20; ++k) {
        glm::dvec3 x = c.light.centre;
        if (c.light.shape == LightShape::rectangle) {
          x += random.uniform(-1.0, 1.0) * c.light.half_u +
               random.uniform(-1.0, 1.0) * c.light.half_v;
        } else {
          x += c.light.radius * random.direction();
        }
        ASSERT_LT(glm::dot(glm::dvec3(end.plane), v - x), 0.0) << "case " << i;
        const glm::dvec3 far = end.reach(x, v);
        ASSERT_NEAR(value(end, far), 0.0, 1e-9 * (1.0 + glm::length(far)));
        ASSERT_GT(glm::dot(far - v, v - x), 0.0);
      }
    }
  }
}

// With a floor below and the light above, is the plane just below the floor?
TEST(Extent, EndsJustBelowTheFloor) {
  Random random(82);
  Case c = random_case(random);
  c.light.shape = LightShape::sphere;
  c.light.radius = 0.2;
  c.light.centre = {0.5, 9.0, 0.3};
  const EndPlane end = choose_end_plane(c.caster, c.silhouette, c.light, c.bounds, std::nullopt);
  EXPECT_NEAR(end.plane.y, 1.0, 1e-12);
  EXPECT_GT(end.plane.w, 0.0);
  EXPECT_LT(end.plane.w, 0.01 * c.bounds.diagonal());
}

TEST(Extent, FixedLengthEndsThatFarBehindTheCaster) {
  Random random(83);
  for (int i = 0; i < 200; ++i) {
    const Case c = random_case(random);
    const EndPlane end = choose_end_plane(c.caster, c.silhouette, c.light, c.bounds, 1.25);
    double nearest = 1e300;
    for (const glm::dvec3& v : c.caster.positions) nearest = std::min(nearest, value(end, v));
    ASSERT_NEAR(nearest, 1.25, 1e-9) << "case " << i;
  }
}

TEST(Extent, ALightThatSurroundsTheCasterIsRefused) {
  Random random(84);
  Case c = random_case(random);
  c.light.shape = LightShape::sphere;
  c.light.centre = {0.0, 1.5, 0.1};
  c.light.radius = 0.2;  // among the vertices: rays go every way
  EXPECT_THROW(choose_end_plane(c.caster, c.silhouette, c.light, c.bounds, std::nullopt),
               InputError);
}

TEST(Extent, BoundsHoldEveryObject) {
  Object one;
  one.mesh.positions = {{1, 2, 3}, {-1, 0, 5}};
  Object two;
  two.mesh.positions = {{0, 9, 4}};
  const std::vector<Object> objects{one, two};
  const Bounds bounds = bounds_of(objects);
  EXPECT_EQ(bounds.low, glm::dvec3(-1, 0, 3));
  EXPECT_EQ(bounds.high, glm::dvec3(1, 9, 5));
  EXPECT_NEAR(bounds.diagonal(), std::sqrt(4.0 + 81.0 + 4.0), 1e-12);
}

TEST(Extent, LightCornersGoRoundTheRectangle) {
  Light light;
  light.centre = {0, 5, 0};
  light.half_u = {1, 0, 0};
  light.half_v = {0, 0, 2};
  const auto corners = light_corners(light);
  ASSERT_EQ(corners.size(), 4U);
  for (std::size_t i = 0; i < 4; ++i) {
    const double side = glm::distance(corners[i], corners[(i + 1) % 4]);
    EXPECT_NEAR(side, i % 2 == 0 ? 2.0 : 4.0, 1e-12);
  }
  light.shape = LightShape::sphere;
  EXPECT_EQ(light_corners(light), std::vector<glm::dvec3>{light.centre});
}

}  // namespace
}  // namespace wedgesim::functional
