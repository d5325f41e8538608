// Is a camera found again in the matrix of its projection?
#include "functional/scene/clip_matrix.h"

#include <gtest/gtest.h>

#include <glm/ext/matrix_clip_space.hpp>
#include <glm/ext/matrix_transform.hpp>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

namespace wedgesim::functional {
namespace {

constexpr double kAspect = 1.5;
const glm::dvec3 kEye{3.0, 4.0, 8.0};
const glm::dvec3 kTarget{0.5, 1.0, -1.0};
const glm::dvec3 kUp{0.1, 1.0, 0.0};

glm::dmat4 matrix(double aspect = kAspect) {
  return glm::perspective(glm::radians(50.0), aspect, 0.1, 100.0) * glm::lookAt(kEye, kTarget, kUp);
}

// glm's projections share nothing with the renderer's.
TEST(ClipMatrix, GivesBackTheCamera) {
  for (const double scale : {1.0, 0.01, 300.0}) {
    Camera camera;
    ASSERT_EQ(camera_of_clip_matrix(scale * matrix(), kAspect, camera), "");
    EXPECT_LT(glm::distance(camera.eye, kEye), 1e-9);
    const glm::dvec3 ahead = glm::normalize(kTarget - kEye);
    EXPECT_LT(glm::distance(glm::normalize(camera.target - camera.eye), ahead), 1e-9);
    EXPECT_NEAR(camera.field_of_view_degrees, 50.0, 1e-9);
    EXPECT_NEAR(glm::dot(camera.up, glm::normalize(glm::cross(ahead, kUp))), 0.0, 1e-9);
    EXPECT_GT(glm::dot(camera.up, kUp), 0.5);
  }
}

TEST(ClipMatrix, SaysWhatIsNoSuchCamera) {
  Camera camera;
  const auto wrong = [&](const glm::dmat4& m) { return camera_of_clip_matrix(m, kAspect, camera); };
  EXPECT_NE(wrong(glm::ortho(-1.0, 1.0, -1.0, 1.0)).find("no perspective"), std::string::npos);
  EXPECT_NE(wrong(matrix(1.0)).find("pixels"), std::string::npos);
  const glm::dmat4 mirrored = glm::scale(glm::dmat4(1.0), {-1.0, 1.0, 1.0}) * matrix();
  EXPECT_NE(wrong(mirrored).find("mirrored"), std::string::npos);
  glm::dmat4 shifted = matrix();
  for (int column = 0; column < 4; ++column) shifted[column][0] += 0.1 * shifted[column][3];
  EXPECT_NE(wrong(shifted).find("off centre"), std::string::npos);
}

}  // namespace
}  // namespace wedgesim::functional
