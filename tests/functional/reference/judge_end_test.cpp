#include "functional/reference/judge_end.h"

#include <gtest/gtest.h>

#include <array>

namespace wedgesim::functional {
namespace {

double value_at(const RealPlane& plane, const RealVector& p) {
  return Real(dot(plane.inward, p - plane.through)).convert_to<double>();
}

// Receivers from (-2, 0, -4) to (2, 5, 16), whose diagonal is 21; the caster's vertices have their
// middle at (1, 3, 0), the light is at (1, 7, 3): the way between is (0, -4, -3)/5.
struct Case {
  Scene scene;
  Frame frame;

  Case() {
    scene.light.centre = {1.0, 7.0, 3.0};
    scene.light.half_u = {0.0, 0.0, 0.5};
    scene.light.half_v = {0.25, 0.0, 0.0};
    scene.objects.resize(2);
    scene.objects[0].mesh.positions = {{-2.0, 0.0, -4.0}, {2.0, 5.0, 16.0}};
    scene.objects[1].mesh.positions = {{0.0, 3.0, 0.0}, {2.0, 2.0, 0.0}, {1.0, 4.0, 0.0}};
    frame.geometry.end_sides.resize(2);
  }
  double value(EndSide side, const glm::dvec3& p) {
    frame.geometry.end_sides[1] = side;
    const RealPlane plane = judged_end(scene, frame, 1);
    return value_at(plane, RealVector(p) - RealVector(scene.light.centre));
  }
};

constexpr double kBeyond = 0.042;  // 21 / 500

TEST(JudgeEnd, SidesOfTheBounds) {
  Case c;
  const glm::dvec3 p(0.5, 1.5, 2.5);
  EXPECT_DOUBLE_EQ(c.value(EndSide::low_x, p), 2.5 + kBeyond);
  EXPECT_DOUBLE_EQ(c.value(EndSide::high_x, p), 1.5 + kBeyond);
  EXPECT_DOUBLE_EQ(c.value(EndSide::low_y, p), 1.5 + kBeyond);
  EXPECT_DOUBLE_EQ(c.value(EndSide::high_y, p), 3.5 + kBeyond);
  EXPECT_DOUBLE_EQ(c.value(EndSide::low_z, p), 6.5 + kBeyond);
  EXPECT_DOUBLE_EQ(c.value(EndSide::high_z, p), 13.5 + kBeyond);
}

TEST(JudgeEnd, AcrossTheLightOrTheWayToTheCaster) {
  Case c;
  // half_u x half_v points up.
  EXPECT_DOUBLE_EQ(c.value(EndSide::across_light, {9.0, 1.5, 9.0}), 3.5 + kBeyond);
  // The receivers' corner farthest that way is (x, 0, -4): 12/5 from the origin.
  EXPECT_DOUBLE_EQ(c.value(EndSide::across_way, {9.0, 0.0, 0.0}), 2.4 + kBeyond);
  c.scene.light.shape = LightShape::sphere;
  EXPECT_DOUBLE_EQ(c.value(EndSide::across_light, {9.0, 0.0, 0.0}), 2.4 + kBeyond);
}

TEST(JudgeEnd, FixedLength) {
  Case c;
  c.frame.length = 1.25;
  // The caster's vertex farthest that way is (2, 2, 0): -8/5.
  EXPECT_DOUBLE_EQ(c.value(EndSide::fixed_length, {0.0, 0.0, 0.0}), -1.6 + 1.25);
}

// Another renderer's depth may show more than the scene holds: its bounds are data.
TEST(JudgeEnd, GivenDepth) {
  Case c;
  c.frame.origin = {0.0, 100.0, 0.0};
  c.frame.receivers = {{-2.0, -103.0, -4.0}, {2.0, -95.0, 0.0}};  // a diagonal of sqrt(96)
  EXPECT_DOUBLE_EQ(c.value(EndSide::low_y, {0.0, 0.0, 0.0}), kBeyond);
  c.frame.depth_given = true;
  EXPECT_NEAR(c.value(EndSide::low_y, {0.0, 0.0, 0.0}), 3.0 + std::sqrt(96.0) / 500.0, 1e-14);
}

}  // namespace
}  // namespace wedgesim::functional
