#include "functional/scene/origin.h"

#include <gtest/gtest.h>

#include "functional/scene/primitives.h"

namespace wedgesim::functional {
namespace {

Scene box_at(const glm::dvec3& offset) {
  Scene scene;
  scene.camera.eye = offset + glm::dvec3(3, 2, 1);
  scene.camera.target = offset;
  scene.light.centre = offset + glm::dvec3(0, 5, 0);
  scene.light.half_u = {1, 0, 0};
  scene.light.half_v = {0, 0, 1};
  scene.objects.push_back({make_box({1, 1, 1}), true, {}});
  for (glm::dvec3& p : scene.objects[0].mesh.positions) p += offset;
  return scene;
}

// Do scenes near the world's origin stay as they are, bit for bit?
TEST(Origin, OfAScenePlacedSensiblyIsTheWorlds) {
  EXPECT_EQ(best_origin(box_at({0, 0, 0})), glm::dvec3(0.0));
  EXPECT_EQ(best_origin(box_at({20, 0, 0})), glm::dvec3(0.0));
}

// Is a far scene taken from its eye, and does nothing but positions change?
TEST(Origin, OfAFarSceneIsItsEye) {
  const glm::dvec3 offset{1048576.0, -65536.0, 0.0};  // sums are exact
  const Scene far = box_at(offset);
  const glm::dvec3 origin = best_origin(far);
  EXPECT_EQ(origin, far.camera.eye);
  const Scene moved = taken_from(far, origin);
  const Scene near = taken_from(box_at({0, 0, 0}), glm::dvec3(3, 2, 1));
  EXPECT_EQ(moved.camera.eye, glm::dvec3(0.0));
  EXPECT_EQ(moved.camera.target, near.camera.target);
  EXPECT_EQ(moved.light.centre, near.light.centre);
  EXPECT_EQ(moved.light.half_u, near.light.half_u);
  EXPECT_EQ(moved.objects[0].mesh.positions, near.objects[0].mesh.positions);
}

// A caster close to the light keeps its distance from it, however far away the eye is.
TEST(Origin, OfACasterCloseToTheLightIsTheLight) {
  Scene far = box_at({1048576.0, 0.0, 0.0});
  far.light.centre.y = 1.0 + 1.0 / 1024.0;
  EXPECT_EQ(best_origin(far), far.light.centre);
}

}  // namespace
}  // namespace wedgesim::functional
