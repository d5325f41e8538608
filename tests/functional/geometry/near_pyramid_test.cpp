#include "functional/geometry/near_pyramid.h"

#include <gtest/gtest.h>

#include <array>
#include <glm/geometric.hpp>

#include "functional/geometry/polyhedron.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

Window plain_window() {
  Camera camera;
  camera.eye = {0.0, 0.0, 0.0};
  camera.target = {0.0, 0.0, -1.0};
  camera.field_of_view_degrees = 60.0;
  camera.near_plane = 1.0;
  camera.far_plane = 20.0;
  return make_window(camera, 200, 100);
}

// A point of the pyramid from the eye to the near rectangle, by construction.
glm::dvec3 inside_pyramid(Random& random, const Window& window, double least, double most) {
  const glm::dvec3 on_rectangle =
      world_point(window, random.uniform(0.0, 200.0), random.uniform(0.0, 100.0), 0.0);
  return window.eye + random.uniform(least, most) * (on_rectangle - window.eye);
}

bool in_pyramid(const Window& window, const glm::dvec3& p) {
  const glm::dvec4 h = window.window_from_world * glm::dvec4(p, 1.0);
  return h.w >= 0.0 && h.w <= 1.0 && h.x >= 0.0 && h.x <= 200.0 * h.w && h.y >= 0.0 &&
         h.y <= 100.0 * h.w;
}

// Does a triangle through a point of the pyramid meet it, and one that samples say misses it not?
TEST(NearPyramid, MeetsPolygons) {
  Random random(91);
  const Window window = plain_window();
  const NearPyramid pyramid(window);
  EXPECT_EQ(pyramid.eye(), window.eye);
  int missed = 0;
  for (int i = 0; i < 5000; ++i) {
    const glm::dvec3 p = inside_pyramid(random, window, 0.01, 0.99);
    const glm::dvec3 a = random.uniform(0.01, 4.0) * random.direction();
    const glm::dvec3 b = random.uniform(0.01, 4.0) * random.direction();
    const std::array<glm::dvec3, 3> through{p + a, p + b, p - 0.5 * (a + b)};
    ASSERT_TRUE(pyramid.meets(through)) << "case " << i;

    const glm::dvec3 c = random.uniform(0.0, 3.0) * random.direction();
    const std::array<glm::dvec3, 3> anywhere{c + a, c + b, c - 0.5 * (a + b)};
    bool sampled = false;
    for (int k = 0; k < 200 && !sampled; ++k) {
      double u = random.uniform(0.0, 1.0);
      double v = random.uniform(0.0, 1.0);
      if (u + v > 1.0) {
        u = 1.0 - u;
        v = 1.0 - v;
      }
      sampled = in_pyramid(
          window, anywhere[0] + u * (anywhere[1] - anywhere[0]) + v * (anywhere[2] - anywhere[0]));
    }
    const bool met = pyramid.meets(anywhere);
    ASSERT_TRUE(met || !sampled) << "case " << i;
    if (!met) ++missed;
  }
  EXPECT_GT(missed, 1000) << "it says yes to everything";
  const std::array<glm::dvec3, 3> beyond{glm::dvec3(-1, 0, -1.01), glm::dvec3(1, 0, -1.01),
                                         glm::dvec3(0, 1, -1.01)};
  EXPECT_FALSE(pyramid.meets(beyond)) << "behind the near plane";
}

// Is a volume that holds a point of the pyramid never missed, and one far from it never met?
TEST(NearPyramid, MayMeetVolumes) {
  Random random(92);
  const Window window = plain_window();
  const NearPyramid pyramid(window);
  for (int i = 0; i < 2000; ++i) {
    const glm::dvec3 p = inside_pyramid(random, window, 0.0, 1.0);
    const auto box_around = [&](const glm::dvec3& middle) {
      std::vector<glm::dvec4> planes;
      for (int k = 0; k < 6; ++k) {
        const glm::dvec3 n = random.direction();
        planes.emplace_back(n, random.uniform(0.01, 1.0) - glm::dot(n, middle));
      }
      Bounds bounds;
      bounds.grow(middle - 3.0);
      bounds.grow(middle + 3.0);
      return intersect_half_spaces(planes, bounds);
    };
    ASSERT_TRUE(pyramid.may_meet(box_around(p))) << "case " << i;
    const glm::dvec3 away = p + glm::dvec3(0.0, 0.0, 8.0);
    ASSERT_FALSE(pyramid.may_meet(box_around(away))) << "case " << i;
  }
}

// Does a plane of the volume alone tell that it misses, where it reaches round the pyramid?
TEST(NearPyramid, VolumesThatReachRoundIt) {
  const Window window = plain_window();
  const NearPyramid pyramid(window);
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0, 1.0, -0.3));
  double reach = 0.0;
  for (const glm::dvec3& p : window.near_rectangle) reach = std::max(reach, glm::dot(n, p));
  Bounds bounds;
  bounds.grow(glm::dvec3(-50.0));
  bounds.grow(glm::dvec3(50.0));
  const auto beyond = [&](double distance) {
    const std::vector<glm::dvec4> planes{glm::dvec4(n, -distance)};
    return intersect_half_spaces(planes, bounds);
  };
  EXPECT_FALSE(pyramid.may_meet(beyond(reach + 1e-6)));
  EXPECT_TRUE(pyramid.may_meet(beyond(reach - 1e-6)));
}

}  // namespace
}  // namespace wedgesim::functional
