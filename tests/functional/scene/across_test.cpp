#include "functional/scene/across.h"

#include <gtest/gtest.h>

namespace wedgesim::functional {
namespace {

TEST(Across, IsARightHandedFrameAboutAnyAxis) {
  for (const glm::dvec3& way :
       {glm::dvec3(1, 0, 0), glm::dvec3(0, 1, 0), glm::dvec3(0, 0, -1), glm::dvec3(3, 4, 0),
        glm::dvec3(-0.6, 0.8, 0), glm::dvec3(-1, 1e-9, 0), glm::dvec3(0.3, -0.2, 0.1)}) {
    const glm::dvec3 axis = glm::normalize(way);
    const Across across(axis);
    EXPECT_NEAR(glm::length(across.u), 1.0, 1e-14);
    EXPECT_NEAR(glm::length(across.v), 1.0, 1e-14);
    EXPECT_NEAR(glm::length(glm::cross(across.u, across.v) - axis), 0.0, 1e-14);
  }
}

}  // namespace
}  // namespace wedgesim::functional
