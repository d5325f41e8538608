#include "functional/raster/window.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/trigonometric.hpp>

#include "base/error.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

Camera random_camera(Random& random) {
  Camera camera;
  camera.eye = random.in_box(glm::dvec3(-20.0), glm::dvec3(20.0));
  camera.target = camera.eye + random.uniform(0.5, 30.0) * random.direction();
  camera.up = random.direction();
  camera.field_of_view_degrees = random.uniform(10.0, 120.0);
  camera.near_plane = random.uniform(0.01, 1.0);
  camera.far_plane = camera.near_plane + random.uniform(1.0, 200.0);
  return camera;
}

Camera plain_camera() {
  Camera camera;
  camera.eye = {1.0, 2.0, 3.0};
  camera.target = {1.0, 2.0, -7.0};  // looks along -z
  camera.field_of_view_degrees = 90.0;
  camera.near_plane = 0.5;
  camera.far_plane = 50.0;
  return camera;
}

glm::dvec3 project(const Window& window, const glm::dvec3& p) {
  const glm::dvec4 h = window.window_from_world * glm::dvec4(p, 1.0);
  return glm::dvec3(h) / h.w;
}

// Is the closed-form inverse the inverse?
TEST(Window, InverseTakesEveryPointBack) {
  Random random(11);
  for (int i = 0; i < 1000; ++i) {
    const Camera camera = random_camera(random);
    const Window window = make_window(camera, random.whole(1, 2000), random.whole(1, 2000));
    const glm::dmat4 product = window.world_from_window * window.window_from_world;
    const glm::dvec3 p = camera.eye + random.in_box(glm::dvec3(-50.0), glm::dvec3(50.0));
    const glm::dvec4 back = product * glm::dvec4(p, 1.0);
    // Pixels, depth and distance along the view mix in the product: the unit is the largest term.
    double unit = 0.0;
    const glm::dvec4 h = window.window_from_world * glm::dvec4(p, 1.0);
    for (int k = 0; k < 4; ++k) {
      for (int j = 0; j < 4; ++j) {
        unit = std::max(unit, std::abs(window.world_from_window[k][j] * h[k]));
      }
    }
    for (int j = 0; j < 3; ++j) ASSERT_NEAR(back[j], p[j], 1e-12 * unit) << "case " << i;
    ASSERT_NEAR(back.w, 1.0, 1e-12 * unit) << "case " << i;
  }
}

// Does x go right, y down, and is the middle of a 1x1 frame its pixel's centre?
TEST(Window, AxesAndPixelCentres) {
  const Camera camera = plain_camera();
  const Window window = make_window(camera, 640, 427);
  const glm::dvec3 middle = project(window, camera.target);
  EXPECT_NEAR(middle.x, 320.0, 1e-10);
  EXPECT_NEAR(middle.y, 213.5, 1e-10);
  EXPECT_GT(project(window, camera.target + glm::dvec3(1, 0, 0)).x, 320.0);
  EXPECT_LT(project(window, camera.target + glm::dvec3(0, 1, 0)).y, 213.5);

  const Window pixel = make_window(camera, 1, 1);
  const glm::dvec3 p = world_point(pixel, 0.5, 0.5, 0.3);
  EXPECT_NEAR(p.x, camera.eye.x, 1e-12);
  EXPECT_NEAR(p.y, camera.eye.y, 1e-12);
}

// Does a point stay on its ray where the near plane is tiny beside the eye's coordinates?
TEST(Window, PointsLeaveTheirRayByOneRounding) {
  Camera camera = plain_camera();
  camera.eye = glm::dvec3(1.21, -1.99, 0.3);
  camera.target = camera.eye + 0x1p-18 * glm::dvec3(-0.5, -0.75, -0.125);
  camera.near_plane = 0x1p-30;
  camera.far_plane = 0x1p-14;
  const Window pixel = make_window(camera, 1, 1);
  const glm::dvec3 way = glm::normalize(camera.target - camera.eye);
  for (const double z : {0.0, 0.99, 0.9999, 1.0}) {
    const glm::dvec3 seen = world_point(pixel, 0.5, 0.5, z) - camera.eye;
    EXPECT_LT(glm::length(seen - glm::dot(seen, way) * way), 0x1p-51) << z;
  }
}

// Does the vertical field of view span the rows, and are pixels square?
TEST(Window, FieldOfViewSpansTheRows) {
  const Camera camera = plain_camera();
  const Window window = make_window(camera, 640, 427);
  const double half = std::tan(glm::radians(45.0));
  EXPECT_NEAR(project(window, camera.eye + glm::dvec3(0, half, -1)).y, 0.0, 1e-10);
  EXPECT_NEAR(project(window, camera.eye + glm::dvec3(0, -half, -1)).y, 427.0, 1e-10);
  const double step_x = project(window, camera.target + glm::dvec3(1, 0, 0)).x - 320.0;
  const double step_y = 213.5 - project(window, camera.target + glm::dvec3(0, 1, 0)).y;
  EXPECT_NEAR(step_x, step_y, 1e-10);
}

// Is the depth 0 on the near plane and 1 on the far plane, and w the distance along the view?
TEST(Window, DepthAndW) {
  Random random(12);
  for (int i = 0; i < 200; ++i) {
    const Camera camera = random_camera(random);
    const Window window = make_window(camera, 160, 107);
    const glm::dvec3 forward = glm::normalize(camera.target - camera.eye);
    const glm::dvec3 aside = 0.3 * random.direction();
    const glm::dvec3 across = aside - glm::dot(aside, forward) * forward;
    const auto at = [&](double distance) {
      return window.window_from_world * glm::dvec4(camera.eye + distance * forward + across, 1.0);
    };
    const glm::dvec4 near = at(camera.near_plane);
    const glm::dvec4 far = at(camera.far_plane);
    EXPECT_NEAR(near.z / near.w, 0.0, 1e-10);
    EXPECT_NEAR(far.z / far.w, 1.0, 1e-10);
    EXPECT_NEAR(near.w, camera.near_plane, 1e-12 * 64.0);
    EXPECT_NEAR(far.w, camera.far_plane, 1e-12 * 1024.0);
  }
}

// Are the near rectangle's corners those of the frame, in order around it, at the near distance?
TEST(Window, NearRectangle) {
  const Camera camera = plain_camera();
  const Window window = make_window(camera, 640, 427);
  const double x[4] = {0.0, 640.0, 640.0, 0.0};
  const double y[4] = {0.0, 0.0, 427.0, 427.0};
  for (std::size_t i = 0; i < 4; ++i) {
    const glm::dvec3 p = project(window, window.near_rectangle[i]);
    EXPECT_NEAR(p.x, x[i], 1e-9);
    EXPECT_NEAR(p.y, y[i], 1e-9);
    EXPECT_NEAR(window.near_rectangle[i].z, camera.eye.z - camera.near_plane, 1e-12);
  }
}

// Is a window plane's value at a window point the world value divided by w?
TEST(Window, PlaneValueIsWorldValueOverW) {
  Random random(13);
  for (int i = 0; i < 1000; ++i) {
    const Camera camera = random_camera(random);
    const Window window = make_window(camera, 640, 427);
    const glm::dvec4 plane(random.direction(), random.uniform(-20.0, 20.0));
    const glm::dvec4 in_window = window_plane(window, plane);
    const double x = random.uniform(0.0, 640.0);
    const double y = random.uniform(0.0, 427.0);
    const double z = random.uniform(0.0, 1.0);
    const glm::dvec3 p = world_point(window, x, y, z);
    const double w = (window.window_from_world * glm::dvec4(p, 1.0)).w;
    const double world_value = glm::dot(glm::dvec3(plane), p) + plane.w;
    const double window_value = in_window.x * x + in_window.y * y + in_window.z * z + in_window.w;
    ASSERT_GT(w, 0.0);
    ASSERT_NEAR(window_value * w, world_value, 1e-9 * (1.0 + glm::length(p))) << "case " << i;
  }
}

TEST(Window, RefusesWhatCannotBeSeenThrough) {
  const auto refused = [](auto change) {
    Camera camera = plain_camera();
    change(camera);
    EXPECT_THROW(make_window(camera, 16, 16), InputError);
  };
  refused([](Camera& c) { c.near_plane = 0.0; });
  refused([](Camera& c) { c.near_plane = -1.0; });
  refused([](Camera& c) { c.far_plane = c.near_plane; });
  refused([](Camera& c) { c.far_plane = INFINITY; });
  refused([](Camera& c) { c.near_plane = NAN; });
  refused([](Camera& c) { c.target = c.eye; });
  refused([](Camera& c) { c.up = c.target - c.eye; });
  refused([](Camera& c) { c.up = glm::dvec3(0.0); });
}

}  // namespace
}  // namespace wedgesim::functional
