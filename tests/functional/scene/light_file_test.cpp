#include "functional/scene/light_file.h"

#include <gtest/gtest.h>

#include <glm/geometric.hpp>

#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

LightFile light_of(const std::string& text) {
  const toml::table root = parse_toml(text, "a.toml");
  return read_light(TomlTable(root, "a.toml"));
}

std::string error_of(const std::string& text) {
  return input_error_of([&] { light_of(text); });
}

void expect_near(glm::dvec3 a, glm::dvec3 b) { EXPECT_LT(glm::distance(a, b), 1e-12); }

TEST(LightFile, RectangleShinesAtItsTarget) {
  const Light light =
      light_of("centre = [1, 5, 2]\ntarget = [4, 1, 2]\nsize = [2, 3]\nroll = 30.0").light;
  EXPECT_EQ(light.shape, LightShape::rectangle);
  expect_near(glm::normalize(glm::cross(light.half_u, light.half_v)), {0.6, -0.8, 0.0});
  EXPECT_DOUBLE_EQ(glm::length(light.half_u), 1.0);
  EXPECT_DOUBLE_EQ(glm::length(light.half_v), 1.5);
  EXPECT_NEAR(glm::dot(light.half_u, light.half_v), 0.0, 1e-15);
}

TEST(LightFile, HalfUIsLevelBeforeRollAndTurnsWithIt) {
  const auto half_u = [](const std::string& roll) {
    return light_of("centre = [0, 0, 0]\ntarget = [1, -1, 0]\nsize = [2, 2]\nroll = " + roll)
        .light.half_u;
  };
  EXPECT_NEAR(half_u("0").y, 0.0, 1e-15);
  EXPECT_GT(std::abs(half_u("90").y), 0.5);
}

TEST(LightFile, StraightDownWorks) {
  const Light light = light_of("centre = [0, 5, 0]\ntarget = [0, 0, 0]\nsize = [2, 4]").light;
  expect_near(glm::cross(light.half_u, light.half_v), {0.0, -2.0, 0.0});
}

TEST(LightFile, HalfAxesMayBeGiven) {
  const LightFile file = light_of("centre = [0, 5, 0]\nhalf_u = [1, 0, 0]\nhalf_v = [0, 0, 2]");
  EXPECT_EQ(file.light.half_v, glm::dvec3(0, 0, 2));
  EXPECT_EQ(file.target, glm::dvec3(0, 3, 0));
}

TEST(LightFile, LightsWithoutExtentAreAllowed) {
  EXPECT_EQ(error_of("centre = [0, 5, 0]\ntarget = [0, 0, 0]\nsize = [0, 0]"), "");
  EXPECT_EQ(error_of("shape = 'sphere'\ncentre = [0, 5, 0]\nradius = 0"), "");
  EXPECT_EQ(light_of("shape = 'point'\ncentre = [0, 5, 0]").light.shape, LightShape::point);
}

TEST(LightFile, ReshapingKeepsCentreAndColour) {
  const LightFile file =
      light_of("centre = [0, 5, 0]\ntarget = [0, 0, 0]\nsize = [2, 4]\ncolour = [1, 0.5, 0]");
  const Light sphere = reshaped(file, LightShape::sphere);
  EXPECT_EQ(sphere.shape, LightShape::sphere);
  EXPECT_DOUBLE_EQ(sphere.radius, 1.5);
  EXPECT_EQ(sphere.half_u, glm::dvec3(0.0));
  EXPECT_EQ(sphere.colour, file.light.colour);
  EXPECT_EQ(reshaped(file, LightShape::rectangle).half_u, file.light.half_u);
  EXPECT_EQ(reshaped(file, LightShape::point).radius, 0.0);

  const LightFile ball = light_of("shape = 'sphere'\ncentre = [0, 5, 0]\nradius = 0.5");
  const Light square = reshaped(ball, LightShape::rectangle);
  expect_near(glm::cross(square.half_u, square.half_v), {0.0, -0.25, 0.0});

  const LightFile line = light_of("centre = [0, 5, 0]\ntarget = [0, 0, 0]\nsize = [0, 4]");
  EXPECT_EQ(reshaped(line, LightShape::sphere).radius, 0.0);
}

TEST(LightFile, Errors) {
  EXPECT_EQ(error_of("shape = 'disc'\ncentre = [0, 5, 0]"),
            "a.toml:1: 'shape' is 'disc'; expected rectangle, sphere or point");
  EXPECT_EQ(error_of("centre = [0, 5, 0]\nsize = [1, -1]\ntarget = [0, 0, 0]"),
            "a.toml:2: 'size' is -1; expected a number from 0 to 1e+12");
  EXPECT_EQ(error_of("centre = [0, 5, 0]\nsize = [1, 1]\ntarget = [0, 5, 0]"),
            "a.toml:3: 'target' is the light's centre; expected a point elsewhere");
  EXPECT_EQ(error_of("centre = [0, 5, 0]\nhalf_u = [1, 0, 0]\nhalf_v = [1, 0, 1]"),
            "a.toml:3: 'half_v' is not orthogonal to 'half_u'; expected orthogonal half axes");
  EXPECT_EQ(error_of("shape = 'sphere'\ncentre = [0, 5, 0]\nradius = 1\nsize = [1, 1]"),
            "a.toml:4: unknown key 'size'; expected one of shape, centre, colour, radius, target");
}

}  // namespace
}  // namespace wedgesim::functional
