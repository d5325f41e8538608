#include "functional/methods/light_intensity.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "functional/geometry/linear_wedge.h"
#include "functional/geometry/silhouette.h"
#include "functional/light/coverage.h"
#include "functional/methods/frame.h"
#include "functional/scene/primitives.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/geometry/penumbra.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const SceneInfo& info : built_in_scenes()) names.push_back(info.name);
  return names;
}

class ScenesOfLight : public testing::TestWithParam<std::tuple<std::string, LightShape>> {
 protected:
  void SetUp() override {
    if (std::get<0>(GetParam()) == "bunny" &&
        !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
      GTEST_SKIP() << "the package glmark2-data is not installed";
    }
    if (GetParam() == std::tuple("fire", LightShape::sphere)) {
      GTEST_SKIP() << "its light's texture wants a rectangle";
    }
  }
  // Small frames from all along the camera's path.
  template <typename Check>
  void for_each_frame(const Check& check) {
    const auto& [name, shape] = GetParam();
    SceneOptions options;
    options.size = {160, 107};
    options.light_shape = shape;
    const int frames = load_scene(name, options).frames;
    for (const int eighth : {0, 1, 3, 4, 6, 7}) {
      options.frame = eighth * (frames - 1) / 7;
      const Scene scene = load_scene(name, options);
      check(scene, make_frame(scene));
    }
  }
};

INSTANTIATE_TEST_SUITE_P(BuiltIn, ScenesOfLight,
                         testing::Combine(testing::ValuesIn(scene_names()),
                                          testing::Values(LightShape::rectangle,
                                                          LightShape::sphere)),
                         [](const auto& parameter) {
                           std::string name = std::get<0>(parameter.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + (std::get<1>(parameter.param) == LightShape::rectangle
                                              ? "_rectangle"
                                              : "_sphere");
                         });

bool is_sky(const Frame& frame, std::size_t pixel) {
  return frame.depth.triangle[pixel] == DepthBuffer::kSky;
}

// With the eye outside all volumes, do z-pass and z-fail give every surface the same light?
TEST_P(ScenesOfLight, ZPassIsZFail) {
  double worst = 0.0;
  int frames = 0;
  for_each_frame([&](const Scene& scene, const Frame& frame) {
    if (frame.trace.header.z_fail_needed) return;
    ++frames;
    const LightIntensity fail = evaluate_light_intensity(
        scene, frame.window, frame.depth, frame.geometry, frame.trace, fb::ZMethod_fail);
    for (std::size_t pixel = 0; pixel < fail.li.size(); ++pixel) {
      if (is_sky(frame, pixel)) continue;
      const double difference = std::abs(fail.li[pixel] - frame.trace.expected_li[pixel]);
      worst = std::max(worst, difference);
      ASSERT_LE(difference, 1e-12)
          << "frame " << scene.frame << ", pixel " << pixel % 160 << ' ' << pixel / 160;
    }
  });
  std::cout << frames << " frames in z-pass, largest difference " << worst << '\n';
  EXPECT_TRUE(frames > 0 || std::get<0>(GetParam()) == "eye-in-shadow");
}

// Is every point whose light is not 1 minus a whole number inside some wedge?
TEST_P(ScenesOfLight, WholeOutsideEveryWedge) {
  std::int64_t partly = 0;
  for_each_frame([&](const Scene& scene, const Frame& frame) {
    for (std::size_t pixel = 0; pixel < frame.depth.words.size(); ++pixel) {
      const double li = frame.trace.expected_li[pixel];
      if (is_sky(frame, pixel) || (li == std::nearbyint(li) && li <= 1.0)) continue;
      ++partly;
      const glm::dvec3 p =
          world_point(frame.window, static_cast<double>(pixel % 160) + 0.5,
                      static_cast<double>(pixel / 160) + 0.5,
                      traces::decode_depth(frame.depth.format, frame.depth.words[pixel]));
      const bool in_wedge = std::any_of(
          frame.geometry.wedges.begin(), frame.geometry.wedges.end(), [&](const auto& wedge) {
            return std::all_of(wedge.planes.begin(), wedge.planes.end(),
                               [&](const SidedPlane& plane) { return plane.inside(p); });
          });
      ASSERT_TRUE(in_wedge) << "frame " << scene.frame << ", pixel " << pixel % 160 << ' '
                            << pixel / 160 << ": " << li;
    }
  });
  EXPECT_GT(partly, 200);
}

// The wedges of a loop with what penumbra_share wants of them.
std::vector<ShadowWedge> shadow_wedges(const std::vector<LinearWedge>& wedges) {
  std::vector<ShadowWedge> result;
  for (const LinearWedge& wedge : wedges) {
    ShadowWedge shadow;
    for (std::size_t k = 0; k < 5; ++k) shadow.planes.emplace_back(wedge.volume.planes[k]);
    shadow.factors = wedge.factors;
    result.push_back(shadow);
  }
  return result;
}

double linear_share(const Light& light, const ShadowWedge& wedge, const glm::dvec3& p) {
  return penumbra_share(light, fb::WedgeKind_linear, wedge, p, glm::dvec3(0.0), true);
}

double value(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

// Whether the front planes of neighbours meet in their common side plane, and the back planes too:
// nearly always; where they would meet too far aside the side plane is placed more simply.
bool meet_in_side(const WorldWedge& one, const WorldWedge& next) {
  const glm::dvec3 side(one.planes[3]);
  for (std::size_t q = 0; q < 2; ++q) {
    const glm::dvec3 line = glm::cross(glm::dvec3(one.planes[q]), glm::dvec3(next.planes[q]));
    if (std::abs(glm::dot(line, side)) > 1e-9 * glm::length(line)) return false;
  }
  return true;
}

// The linear intensity: 1 on the front plane, 0 on the back plane, between them inside, and the
// same on both sides of a side plane (Paper I, 4.2).
TEST(LinearIntensity, RunsFromFrontToBackWithoutSteps) {
  Random random(131);
  int on_sides = 0;
  int irregular = 0;
  for (int i = 0; i < 300; ++i) {
    const Light light =
        random_light(random, random.chance(0.5) ? LightShape::rectangle : LightShape::sphere);
    Mesh mesh = random.chance(0.5) ? make_box({1.5, 0.8, 1.2})
                                   : make_sphere(random.uniform(0.4, 1.0), 12, 7);
    const glm::dvec3 place = random.in_box({-2.0, 1.6, -2.0}, {2.0, 4.0, 2.0});
    for (glm::dvec3& p : mesh.positions) p += place;
    const Silhouette silhouette = find_silhouette(mesh, light.centre);
    Bounds bounds;
    bounds.grow(kReceiversLow);
    bounds.grow(kReceiversHigh);
    const EndPlane end = choose_end_plane(mesh, silhouette, light, bounds, std::nullopt);
    std::vector<glm::dvec3> loop;
    for (const SilhouetteEdge& edge : silhouette.loops[0]) {
      loop.push_back(mesh.positions[edge.begin]);
    }
    const auto wedges = linear_wedges(light, loop, end, bounds);
    const auto shadows = shadow_wedges(wedges);
    for (std::size_t k = 0; k < wedges.size(); ++k) {
      const LinearWedge& wedge = wedges[k];
      const ShadowWedge& next = shadows[(k + 1) % wedges.size()];
      const auto& planes = wedge.volume.planes;
      for (int n = 0; n < 20; ++n) {
        const glm::dvec3 p = wedge.begin + random.uniform(0.0, 1.0) * (wedge.end - wedge.begin) +
                             random.uniform(0.1, 2.0) * glm::normalize(wedge.begin - light.centre) +
                             0.3 * random.direction();
        const auto project = [&](const glm::dvec4& plane) {
          return p - value(plane, p) * glm::dvec3(plane);
        };
        ASSERT_NEAR(linear_share(light, shadows[k], project(planes[0])), 1.0, 1e-9);
        ASSERT_NEAR(linear_share(light, shadows[k], project(planes[1])), 0.0, 1e-9);
        bool inside = true;
        for (std::size_t q = 0; q < 5; ++q) inside &= value(planes[q], p) >= 0.0;
        if (inside) {
          const double share = linear_share(light, shadows[k], p);
          ASSERT_GE(share, 0.0);
          ASSERT_LE(share, 1.0);
        }
        // On the common side plane, between both front and both back planes.
        const glm::dvec3 side = project(planes[3]);
        bool between = meet_in_side(wedge.volume, wedges[(k + 1) % wedges.size()].volume);
        irregular += between ? 0 : 1;
        for (std::size_t q = 0; q < 2; ++q) {
          between &= value(planes[q], side) > 1e-6;
          between &= value(wedges[(k + 1) % wedges.size()].volume.planes[q], side) > 1e-6;
        }
        // Not where side planes have crossed: each wedge's other side still beyond.
        between &= value(planes[2], side) > 1e-6;
        between &= value(wedges[(k + 1) % wedges.size()].volume.planes[3], side) > 1e-6;
        if (!between) continue;
        ++on_sides;
        ASSERT_NEAR(linear_share(light, shadows[k], side), linear_share(light, next, side), 1e-9)
            << "case " << i << ", wedge " << k;
      }
    }
  }
  std::cout << on_sides << " points on common sides; " << irregular << " on irregular ones\n";
  EXPECT_GT(on_sides, 5000);
  EXPECT_LT(irregular, on_sides / 10);
}

}  // namespace
}  // namespace wedgesim::functional
