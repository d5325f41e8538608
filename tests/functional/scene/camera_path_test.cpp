#include "functional/scene/camera_path.h"

#include <gtest/gtest.h>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

const std::vector<CameraKey> kKeys = {
    {{0, 0, 0}, {0, 0, -1}, 4}, {{4, 0, 0}, {4, 0, -1}, 2}, {{4, 2, 0}, {4, 2, -1}, 0}};

TEST(CameraPath, CountsFrames) {
  EXPECT_EQ(frame_count({}), 1);
  EXPECT_EQ(frame_count({kKeys[0]}), 1);
  EXPECT_EQ(frame_count(kKeys), 7);
}

TEST(CameraPath, BothWaysPassThroughTheKeys) {
  for (const Interpolation way : {Interpolation::linear, Interpolation::catmull_rom}) {
    EXPECT_EQ(camera_at({}, kKeys, way, 0).eye, kKeys[0].eye);
    EXPECT_EQ(camera_at({}, kKeys, way, 4).eye, kKeys[1].eye);
    EXPECT_EQ(camera_at({}, kKeys, way, 6).target, kKeys[2].target);
  }
}

TEST(CameraPath, LinearIsEven) {
  EXPECT_EQ(camera_at({}, kKeys, Interpolation::linear, 1).eye, glm::dvec3(1, 0, 0));
  EXPECT_EQ(camera_at({}, kKeys, Interpolation::linear, 5).eye, glm::dvec3(4, 1, 0));
}

TEST(CameraPath, CatmullRomHasTheSlopeOfTheNeighbours) {
  // By hand, at t = 1/2 of the first piece with points 0, 0, 4, 4 in x and 0, 0, 0, 2 in y:
  // (-p0 + 9 p1 + 9 p2 - p3) / 16.
  const glm::dvec3 eye = camera_at({}, kKeys, Interpolation::catmull_rom, 2).eye;
  EXPECT_DOUBLE_EQ(eye.x, (9.0 * 4.0 - 4.0) / 16.0);
  EXPECT_DOUBLE_EQ(eye.y, -2.0 / 16.0);
  // The second piece: 0, 4, 4, 4 in x and 0, 0, 2, 2 in y.
  const glm::dvec3 later = camera_at({}, kKeys, Interpolation::catmull_rom, 5).eye;
  EXPECT_DOUBLE_EQ(later.x, (9.0 * 8.0 - 4.0) / 16.0);
  EXPECT_DOUBLE_EQ(later.y, (9.0 * 2.0 - 2.0) / 16.0);
}

TEST(CameraPath, KeepsTheRestOfTheCamera) {
  Camera camera;
  camera.field_of_view_degrees = 33.0;
  camera.eye = {9, 9, 9};
  EXPECT_EQ(camera_at(camera, kKeys, Interpolation::linear, 3).field_of_view_degrees, 33.0);
  EXPECT_EQ(camera_at(camera, {}, Interpolation::linear, 0).eye, camera.eye);
}

TEST(CameraPath, FramesBeyondThePathAreABug) {
  EXPECT_THROW(camera_at({}, kKeys, Interpolation::linear, 7), CheckError);
  EXPECT_THROW(camera_at({}, {}, Interpolation::linear, -1), CheckError);
}

}  // namespace
}  // namespace wedgesim::functional
