#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>

#include "functional/raster/window.h"
#include "functional/reference/judge_view.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

// Is a ray as exact as its direction can be, also where the view is almost along up?
TEST(ExactWindow, RaysAreRight) {
  Random random(32);
  constexpr int kSize = 8;
  for (int i = 0; i < 500; ++i) {
    Camera camera;
    camera.eye = random.in_box(glm::dvec3(-3.0), glm::dvec3(3.0));
    const glm::dvec3 ahead = random.direction();
    camera.target = camera.eye + random.uniform(0.5, 3.0) * ahead;
    camera.up = ahead + std::exp2(-random.uniform(0.0, 24.0)) * random.direction();
    const Window window = make_window(camera, kSize, kSize);
    const JudgedView judged(camera, kSize, kSize);
    const auto pixel = static_cast<std::size_t>(random.whole(0, kSize * kSize - 1));
    const RealVector exact =
        judged.from_eye(pixel, judged_depth(traces::fb::DepthFormat_unorm16, 0));
    const glm::dvec3 centre(static_cast<double>(pixel % kSize) + 0.5,
                            static_cast<double>(pixel / kSize) + 0.5, 1.0);
    const RealVector own(camera.near_plane * (window.ray_from_window * centre));
    ASSERT_LT(magnitude(own - exact), 0x1p-49 * magnitude(exact)) << "case " << i;
  }
}

}  // namespace
}  // namespace wedgesim::functional
