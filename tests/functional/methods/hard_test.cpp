// Hard shadow volumes against rays to points of the light.
#include "functional/methods/hard.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <string>

#include "base/error.h"
#include "functional/light/light_cells.h"
#include "functional/methods/render.h"
#include "functional/reference/reference.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

Scene scene_of(const std::string& name) {
  SceneOptions options;
  options.size = {160, 107};
  return load_scene(name, options);
}

View view_of(const Scene& scene, const std::string& method) {
  return render_view(scene, choose_method("test", method));
}

bool is_receiver(const Scene& scene, const DepthBuffer& depth, std::size_t pixel) {
  return depth.triangle[pixel] != DepthBuffer::kSky &&
         !scene.objects[depth.surface(pixel).object].casts;
}

class HardScenes : public testing::TestWithParam<std::string> {};
INSTANTIATE_TEST_SUITE_P(BuiltIn, HardScenes,
                         testing::Values("plain-columns", "fractal", "text2002", "spheres27",
                                         "cylinder", "eye-in-shadow"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

// A ray decides the same, but where it grazes an edge.
TEST_P(HardScenes, IsWhatARayToTheCentreSees) {
  Scene scene = scene_of(GetParam());
  scene.light.shape = LightShape::point;
  const View view = view_of(scene, "hard");
  const std::vector<float> rays = reference_visibility(scene, view.window, view.depth, 1);
  int different = 0;
  int dark = 0;
  for (std::size_t i = 0; i < rays.size(); ++i) {
    if (!is_receiver(scene, view.depth, i)) continue;
    ASSERT_TRUE(view.visibility.values[i] == 0.0F || view.visibility.values[i] == 1.0F);
    different += view.visibility.values[i] != rays[i] ? 1 : 0;
    dark += rays[i] == 0.0F ? 1 : 0;
  }
  std::cout << GetParam() << ": " << different << " of " << dark << " dark pixels differ\n";
  EXPECT_GT(dark, 200);
  EXPECT_LE(different, 4);
}

TEST_P(HardScenes, ZPassIsZFail) {
  const Scene scene = scene_of(GetParam());
  const View fail = view_of(scene, "hard:z=fail");
  EXPECT_EQ(fail.visibility.values, view_of(scene, "hard").visibility.values);
  if (GetParam() == "eye-in-shadow") {
    EXPECT_THROW(view_of(scene, "hard:z=pass"), InputError);
  } else {
    EXPECT_EQ(fail.visibility.values, view_of(scene, "hard:z=pass").visibility.values);
  }
}

double rmse(const Scene& scene, const View& view, const std::vector<float>& reference) {
  double sum = 0.0;
  double count = 0.0;
  for (std::size_t i = 0; i < reference.size(); ++i) {
    if (!is_receiver(scene, view.depth, i)) continue;
    const double error = static_cast<double>(view.visibility.values[i] - reference[i]);
    sum += error * error;
    count += 1.0;
  }
  return std::sqrt(sum / count);
}

TEST(Sampled, ConvergesToRays) {
  for (const LightShape shape : {LightShape::rectangle, LightShape::sphere}) {
    Scene scene = scene_of("columns");
    scene.light.shape = shape;
    scene.light.radius = 0.5;
    const View first = view_of(scene, "sampled-1");
    const std::vector<float> reference =
        reference_visibility(scene, first.window, first.depth, 1024);
    double last = rmse(scene, first, reference);
    for (const char* method : {"sampled-4", "sampled-16", "sampled-64", "sampled-256"}) {
      const double error = rmse(scene, view_of(scene, method), reference);
      std::cout << method << ": RMSE " << error << '\n';
      EXPECT_LT(error, 0.7 * last) << method;
      last = error;
    }
    EXPECT_LT(last, 0.006);
  }
}

TEST(Sampled, OneSampleIsTheHardShadow) {
  const Scene scene = scene_of("boxes");
  EXPECT_EQ(view_of(scene, "sampled-1").visibility.values,
            view_of(scene, "hard").visibility.values);
}

// Every value is a whole number of samples: the bands that its paper's figures show.
// Its words are those of the samples' shadows, a sum's apart.
TEST(Sampled, CountsWhatItsSamplesDo) {
  const Scene scene = scene_of("plain-columns");
  const MethodAccesses one = view_of(scene, "hard").visibility.accesses;
  const MethodAccesses sampled = view_of(scene, "sampled:samples=1").visibility.accesses;
  const std::uint64_t pixels = 160 * 107;
  EXPECT_EQ(sampled.z_reads, one.z_reads);
  EXPECT_EQ(sampled.li_writes, one.li_writes);
  EXPECT_EQ(sampled.li_reads, one.li_reads + pixels);
  EXPECT_EQ(sampled.sums, 2 * pixels);
  EXPECT_EQ(sampled.bytes, one.bytes + pixels + MethodAccesses::kSumBytes * sampled.sums);
  EXPECT_EQ(view_of(scene, "sampled-16").visibility.accesses.sums, 16 * 2 * pixels);
}

TEST(Sampled, ShowsBands) {
  const Scene scene = scene_of("plain-columns");
  for (const float value : view_of(scene, "sampled-16").visibility.values) {
    EXPECT_EQ(16.0F * value, std::nearbyint(16.0F * value));
  }
}

TEST(LightCells, AreSpreadEvenlyOverTheLight) {
  Light light;
  light.half_u = {0.5, 0.0, 0.0};
  light.half_v = {0.0, 0.0, 2.0};
  const auto samples = cell_middles(light, 17, {0.0, -1.0, 0.0});
  ASSERT_EQ(samples.size(), 16U);
  EXPECT_EQ(samples.front(), glm::dvec3(-0.375, 0.0, -1.5));
  light.shape = LightShape::sphere;
  light.radius = 2.0;
  glm::dvec3 sum(0.0);
  for (const glm::dvec3& p : cell_middles(light, 64, {0.0, -1.0, 0.0})) {
    EXPECT_LE(glm::length(p), 2.0);
    EXPECT_NEAR(p.y, 0.0, 1e-12);
    sum += p;
  }
  EXPECT_NEAR(glm::length(sum), 0.0, 1e-9);
  light.shape = LightShape::rectangle;
  EXPECT_EQ(light_parts(light, 2)[3].centre, glm::dvec3(0.25, 0.0, 1.0));
}

}  // namespace
}  // namespace wedgesim::functional
