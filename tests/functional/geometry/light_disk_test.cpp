#include "functional/geometry/light_disk.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

LightDisk random_disk(Random& random) {
  Light light;
  light.shape = LightShape::sphere;
  light.centre = random.in_box(glm::dvec3(-1.0, 8.0, -1.0), glm::dvec3(1.0, 10.0, 1.0));
  light.radius = random.uniform(0.2, 4.0);
  return disk_of(light, random.in_box(glm::dvec3(-3.0), glm::dvec3(3.0)));
}

// Is a triangle called none-frontfacing, all-frontfacing or neither as points of the rim say?
TEST(LightDisk, FacingsAreThoseOfPointsOfTheDisk) {
  Random random(81);
  int counts[4] = {0};
  for (int i = 0; i < 4000; ++i) {
    const LightDisk disk = random_disk(random);
    const std::array<glm::dvec3, 3> triangle{random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0)),
                                             random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0)),
                                             random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0))};
    const glm::dvec3 normal = glm::cross(triangle[1] - triangle[0], triangle[2] - triangle[0]);
    const auto in_front = [&](const glm::dvec3& p) {
      return glm::dot(normal, p - triangle[0]) > 0.0;
    };
    int front = 0;
    constexpr int kPoints = 720;
    for (int k = 0; k < kPoints; ++k) front += in_front(disk.rim(2.0 * M_PI * k / kPoints)) ? 1 : 0;
    const DiskFacing facing = disk_facing(disk, triangle);
    ++counts[static_cast<int>(facing)];
    // Half a degree of the rim is not seen by the points.
    if (front > 3 && front < kPoints - 3) {
      EXPECT_EQ(facing, in_front(disk.centre) ? DiskFacing::front_belt : DiskFacing::back_belt);
    }
    if (facing == DiskFacing::none) {
      EXPECT_EQ(front, 0);
    }
    if (facing == DiskFacing::all) {
      EXPECT_EQ(front, kPoints);
    }
    if (front == 0) {
      EXPECT_LE(facing, DiskFacing::back_belt);
    }
    if (front == kPoints) {
      EXPECT_GE(facing, DiskFacing::front_belt);
    }
  }
  for (const int count : counts) EXPECT_GT(count, 100);
}

// Do the planes through an edge and its extrusion points touch the disk, with all of it on the
// side they should have it, for edges of any direction and those parallel to the disk?
TEST(LightDisk, ExtrusionPlanesTouchTheDisk) {
  Random random(82);
  int found = 0;
  int none = 0;
  for (int i = 0; i < 4000; ++i) {
    const LightDisk disk = random_disk(random);
    const glm::dvec3 a = random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0));
    const glm::dvec3 b = random.chance(0.3) ? a + random.uniform(-1.0, 1.0) * disk.u +
                                                  random.uniform(-1.0, 1.0) * disk.v
                                            : random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0));
    const auto angles = extrusion_angles(disk, a, b);
    if (!angles) {
      // The edge's line meets the disk.
      const double share = disk.height(a) / (disk.height(a) - disk.height(b));
      EXPECT_LT(glm::distance(a + share * (b - a), disk.centre), disk.radius * (1.0 + 1e-9));
      ++none;
      continue;
    }
    ++found;
    for (const bool umbra : {true, false}) {
      const glm::dvec3 p = disk.rim(umbra ? angles->umbra : angles->penumbra);
      const glm::dvec3 outward = glm::normalize(glm::cross(a - p, b - p));
      for (int k = 0; k < 90; ++k) {
        const double side = glm::dot(outward, disk.rim(2.0 * M_PI * k / 90.0) - a);
        if (umbra) {
          EXPECT_LT(side, 1e-7 * disk.radius);
        }
        if (!umbra) {
          EXPECT_GT(side, -1e-7 * disk.radius);
        }
      }
    }
  }
  EXPECT_GT(found, 3000);
  EXPECT_GT(none, 20);
}

TEST(LightDisk, ARectangleBecomesTheDiskOfItsArea) {
  Light light;
  light.half_u = {3.0, 0.0, 0.0};
  light.half_v = {0.0, 0.0, 0.5};
  const LightDisk disk = disk_of(light, glm::dvec3(0.0));
  EXPECT_NEAR(M_PI * disk.radius * disk.radius, 6.0, 1e-12);
  EXPECT_LT(glm::distance(disk.normal, glm::dvec3(0.0, -1.0, 0.0)), 1e-12);
  EXPECT_NEAR(glm::distance(disk.rim(1.0), light.centre), disk.radius, 1e-12);
}

}  // namespace
}  // namespace wedgesim::functional
