#include "functional/scene/lights.h"

#include <gtest/gtest.h>

#include "base/check.h"

namespace wedgesim::functional {
namespace {

TEST(Lights, AreTakenOneAtATime) {
  Scene scene;
  scene.name = "three";
  scene.light.radius = 1.0;
  scene.other_lights.resize(2);
  scene.other_lights[0].radius = 2.0;
  scene.other_lights[1].radius = 3.0;
  ASSERT_EQ(light_count(scene), 3U);
  for (std::size_t i = 0; i < 3; ++i) {
    const double radius = 1.0 + static_cast<double>(i);
    EXPECT_EQ(light_at(scene, i).radius, radius);
    const Scene lit = with_light(scene, i);
    EXPECT_EQ(lit.name, "three");
    EXPECT_EQ(lit.light.radius, radius);
    EXPECT_EQ(light_count(lit), 1U);
  }
  EXPECT_THROW(with_light(scene, 3), CheckError);
}

}  // namespace
}  // namespace wedgesim::functional
