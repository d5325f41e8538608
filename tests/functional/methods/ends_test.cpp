// Eyes that look into a volume through what z-pass leaves open: its end, its light-facing triangles
// before the near plane.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <ostream>
#include <string>

#include "base/error.h"
#include "functional/methods/frame.h"
#include "functional/methods/render.h"
#include "functional/reference/reference.h"
#include "functional/scene/primitives.h"
#include "tests/functional/random.h"
#include "tests/support/invariants.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

// A box over a ground of 18 by 18.
struct Sight {
  std::string name;
  double size;  // of the box, that much above the ground, or on it if it is large
  glm::dvec3 light, eye, target;
  double near_plane;
};

std::ostream& operator<<(std::ostream& out, const Sight& sight) { return out << sight.name; }

const Sight kSunset{"sunset", 1.2, {-40.0, 4.0, 0.0}, {16.0, 3.0, 0.0}, {4.0, 0.0, 0.0}, 0.5};
const Sight kBelow{"below", 1.0, {-2.0, 9.0, 2.0}, {3.2, -5.0, 7.0}, {0.3, 0.0, 0.0}, 0.5};
const Sight kCut{"cut", 6.0, {9.0, 6.0, 0.0}, {3.5, 2.0, 0.0}, {0.0, 0.0, 0.0}, 1.0};

Light light_at(const glm::dvec3& centre) {
  Light light;
  const glm::dvec3 way = glm::normalize(-centre);
  light.centre = centre;
  light.half_u = 0.4 * glm::normalize(glm::cross(way, glm::dvec3(0.1, 0.2, 1.0)));
  light.half_v = glm::cross(way, light.half_u);
  return light;
}

Scene scene_of(const Sight& sight) {
  Scene scene;
  scene.name = sight.name;
  scene.width = 120;
  scene.height = 80;
  scene.camera.eye = sight.eye;
  scene.camera.target = sight.target;
  scene.camera.near_plane = sight.near_plane;
  scene.camera.field_of_view_degrees = 50.0;
  Object ground, box;
  ground.mesh = make_plane({18.0, 18.0}, {2, 2});
  ground.mesh.name = "ground";
  box.casts = true;
  box.mesh = make_box(glm::dvec3(sight.size));
  box.mesh.name = "box";
  const double above = sight.size < 2.0 ? 0.5 : -0.5;
  for (glm::dvec3& p : box.mesh.positions) p.y += above;
  scene.light = light_at(sight.light);
  scene.objects = {ground, box};
  return scene;
}

View view_of(const Scene& scene, const std::string& method) {
  return render_view(scene, choose_method("test", method));
}

class Ends : public testing::TestWithParam<Sight> {};
INSTANTIATE_TEST_SUITE_P(Sights, Ends, testing::Values(kSunset, kBelow, kCut),
                         [](const auto& parameter) { return parameter.param.name; });

bool is_ground(const View& view, std::size_t pixel) {
  return view.depth.triangle[pixel] != DepthBuffer::kSky && view.depth.surface(pixel).object == 0;
}

// Of the ground, root mean square.
double error(const View& view, const std::vector<float>& rays) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!is_ground(view, i)) continue;
    sum += std::pow(static_cast<double>(view.visibility.values[i] - rays[i]), 2.0);
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

TEST_P(Ends, AreSeenAsByRays) {
  Scene scene = scene_of(GetParam());
  const View view = view_of(scene, "coverage");
  const std::vector<float> rays = reference_visibility(scene, view.window, view.depth, 1024);
  int shadowed = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    shadowed += is_ground(view, i) && rays[i] < 0.5F ? 1 : 0;
  }
  EXPECT_GT(shadowed, 60);
  for (const std::string method : {"coverage", "linear", "ssv", "wedge-restructured"}) {
    const double off = error(view_of(scene, method), rays);
    std::cout << GetParam().name << ' ' << method << ": RMSE " << off << '\n';
    EXPECT_LT(off, 0.01) << method;
  }
  scene.light.shape = LightShape::point;
  const View hard = view_of(scene, "hard");
  EXPECT_LT(error(hard, reference_visibility(scene, hard.window, hard.depth, 1)), 0.02);
}

TEST_P(Ends, RefuseZPass) {
  const Scene scene = scene_of(GetParam());
  FrameOptions options;
  options.z_method = fb::ZMethod_pass;
  for (const fb::WedgeKind kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
    options.kind = kind;
    EXPECT_THROW(make_frame(scene, options), InputError);
  }
  for (const std::string method : {"hard", "ssv", "wedge-restructured"}) {
    EXPECT_THROW(view_of(scene, method + ":z=pass"), InputError) << method;
  }
}

// Wherever the eye is: z-pass where it is taken gives what z-fail does, in the block too.
TEST(ZMethod, IsRightFromEverywhere) {
  Random random(71);
  int passed = 0;
  constexpr int kEyes = 60;
  for (int eye = 0; eye < kEyes; ++eye) {
    Scene scene = scene_of(kSunset);
    scene.light = light_at(random.in_box({-9.0, 3.0, -9.0}, {9.0, 12.0, 9.0}));
    scene.camera.eye = random.uniform(1.5, 16.0) * random.direction() + glm::dvec3(0.0, 1.0, 0.0);
    scene.camera.target = random.in_box({-2.0, 0.0, -2.0}, {2.0, 1.0, 2.0});
    scene.camera.near_plane = random.uniform(0.05, 2.0);
    const tests::InvariantReport report = tests::check_invariants(scene, {}, false);
    EXPECT_EQ(report.failure, "") << "eye " << eye;
    passed += report.z_fail ? 0 : 1;
    for (const std::string method : {"hard", "ssv", "wedge-restructured"}) {
      const View one = view_of(scene, method);
      const View other = view_of(scene, method + ":z=fail");
      int differ = 0;
      for (std::size_t i = 0; i < one.depth.words.size(); ++i) {
        if (one.depth.triangle[i] == DepthBuffer::kSky) continue;
        const auto difference = one.visibility.values[i] - other.visibility.values[i];
        differ += std::abs(difference) > 1e-4F ? 1 : 0;
      }
      EXPECT_EQ(differ, 0) << method << ", eye " << eye;
    }
  }
  std::cout << passed << " of " << kEyes << " in z-pass\n";
  EXPECT_GT(passed, kEyes / 4);
  EXPECT_LT(passed, kEyes * 3 / 4);
}

}  // namespace
}  // namespace wedgesim::functional
