#include "functional/scene/skin.h"

#include <gtest/gtest.h>

#include <glm/gtc/constants.hpp>

#include "tests/functional/scene/mesh_facts.h"
#include "tests/support/expect_input_error.h"

namespace wedgesim::functional {
namespace {

constexpr double kPi = glm::pi<double>();

TEST(Lathe, OpenEndsAreClosedByFlatFaces) {
  const Mesh cylinder = make_lathe({{0.5, 0.0}, {0.5, 2.0}}, 128);
  EXPECT_NEAR(sound_volume(cylinder), kPi * 0.25 * 2.0, 1e-3);
  EXPECT_EQ(euler_number(cylinder), 2);
}

TEST(Lathe, ProfileMayEndOnTheAxisAndTurnBack) {
  // A cup: up outside, over the rim, down inside to the axis.
  const Mesh cup = make_lathe({{1.0, 0.0}, {1.0, 1.0}, {0.8, 1.0}, {0.8, 0.2}, {0.0, 0.2}}, 256);
  EXPECT_NEAR(sound_volume(cup), kPi * (1.0 - 0.64 * 0.8), 1e-3);
  EXPECT_EQ(euler_number(cup), 2);
}

TEST(Lathe, RejectsRadiiThatMakeNoSurface) {
  const std::string error =
      "profile: a radius is negative, or 0 before the end; expected radii "
      "above 0, or 0 at either end";
  EXPECT_EQ(input_error_of([] { make_lathe({{-1.0, 0.0}, {1.0, 1.0}}, 8); }), error);
  EXPECT_EQ(input_error_of([] { make_lathe({{1.0, 0.0}, {0.0, 1.0}, {1.0, 2.0}}, 8); }), error);
}

TEST(Sweep, StraightTubeIsACylinderWhateverItsDirection) {
  for (const glm::dvec3 end : {glm::dvec3(2, 0, 0), glm::dvec3(0, -2, 0), glm::dvec3(0, 0, -2)}) {
    const Mesh tube = make_sweep({{0, 0, 0}, end}, {0.5, 0.5}, 128);
    EXPECT_NEAR(sound_volume(tube), kPi * 0.25 * 2.0, 1e-3);
    EXPECT_EQ(euler_number(tube), 2);
  }
}

TEST(Sweep, BentTubeKeepsItsVolume) {
  std::vector<glm::dvec3> path;
  for (int i = 0; i <= 64; ++i) {
    const double angle = kPi * i / 64;
    path.emplace_back(std::cos(angle), std::sin(angle), 0.2 * angle);
  }
  const Mesh tube = make_sweep(path, std::vector<double>(path.size(), 0.2), 64);
  const double length = kPi * std::sqrt(1.0 + 0.04);
  EXPECT_NEAR(sound_volume(tube), kPi * 0.04 * length, 3e-3);
  EXPECT_EQ(euler_number(tube), 2);
}

TEST(Skin, LoopJoinsTheLastRingToTheFirst) {
  const auto ring = [](glm::dvec3 middle, glm::dvec3 out) {
    return std::vector<glm::dvec3>{middle - out, middle + out, middle + glm::dvec3(0, 1, 0)};
  };
  const Mesh loop = skin({ring({1, 0, 0}, {0.3, 0, 0}), ring({0, 0, -1}, {0, 0, -0.3}),
                          ring({-1, 0, 0}, {-0.3, 0, 0}), ring({0, 0, 1}, {0, 0, 0.3})},
                         true);
  EXPECT_GT(std::abs(sound_volume(loop)), 0.1);
  EXPECT_EQ(euler_number(loop), 0);
}

}  // namespace
}  // namespace wedgesim::functional
