// Coverage textures, lights with textures and V-buffers of few bits in `ssv`, against rays, against
// every edge at every pixel, and against exact clipping.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <iostream>
#include <set>

#include "functional/light/coverage_texture.h"
#include "functional/light/split_word.h"
#include "functional/methods/render.h"
#include "functional/reference/reference.h"
#include "functional/scene/light_texture.h"
#include "functional/scene/primitives.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

using Values = std::vector<float>;

Scene scene_of(const std::string& name, bool textured, int width = 96, int height = 64) {
  SceneOptions options;
  options.size = {width, height};
  Scene scene = load_scene(name, options);
  if (textured && !scene.light.texture) {
    scene.light.texture = std::make_shared<const Image>(make_fire(0, 16, 32, 1));
  }
  return scene;
}

Values ssv(const Scene& scene, const std::string& options = "") {
  return render_view(scene, choose_method("", "ssv" + options)).visibility.values;
}

// Rays to each texel.
Values reference(const Scene& scene) {
  const Window window = make_window(scene.camera, scene.width, scene.height);
  return reference_visibility(
      scene, window, render_depth(window, scene.objects, traces::fb::DepthFormat_float32), 1024);
}

double shown(float value) { return std::clamp(static_cast<double>(value), 0.0, 1.0); }

// \param penumbra  only where the truth is between 0 and 1
double rmse(const Values& values, const Values& truth, bool penumbra = false) {
  EXPECT_EQ(values.size(), truth.size());
  double sum = 0.0;
  int count = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (penumbra && (truth[i] <= 0.0F || truth[i] >= 1.0F)) continue;
    sum += std::pow(shown(values[i]) - shown(truth[i]), 2.0);
    ++count;
  }
  EXPECT_GT(count, 100);
  return std::sqrt(sum / count);
}

double largest(const Values& values, const Values& truth) {
  double worst = 0.0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    worst = std::max(worst, std::abs(static_cast<double>(values[i] - truth[i])));
  }
  return worst;
}

// Where the silhouette from the centre is right, textured lights are right (bar: RMSE 0.01).
TEST(SsvTexture, ATexturedLightIsThatOfRaysToItsTexels) {
  for (const std::string name : {"ground-polygon", "plain-columns"}) {
    const Scene scene = scene_of(name, true);
    const Values truth = reference(scene);
    for (const std::string options :
         {"", ":texture=16,filter=quadlinear", ":texture=32", ":texture=32,filter=quadlinear"}) {
      const Values values = ssv(scene, options);
      const double error = rmse(values, truth);
      std::cout << name << " ssv" << options << ": RMSE " << error << ", in penumbrae "
                << rmse(values, truth, true) << '\n';
      EXPECT_LT(error, 0.01);
    }
    const Values even = ssv(scene_of(name, false));
    Values grey;
    for (const float value : even) grey.insert(grey.end(), 3, value);
    EXPECT_GT(rmse(grey, truth), 0.01) << "the texture makes no difference";
  }
}

// An even texture is no texture.
TEST(SsvTexture, AnEvenTextureIsNone) {
  Scene scene = scene_of("plain-columns", false);
  const Values without = ssv(scene);
  Image even(3, 5, 3);
  std::ranges::fill(even.values, 0.7F);
  scene.light.texture = std::make_shared<const Image>(even);
  const Values with = ssv(scene);
  for (std::size_t i = 0; i < without.size(); ++i) {
    for (std::size_t c = 0; c < 3; ++c) ASSERT_NEAR(with[3 * i + c], without[i], 1e-4F) << i;
  }
}

// The artifact texture-quantization: the fewer entries, the farther from exact clipping.
TEST(SsvTexture, FewEntriesShow) {
  const Scene scene = scene_of("cylinder", false, 192, 128);
  const Values exact = ssv(scene);
  double before = 1.0;
  for (const std::string side : {"8", "16", "32", "64"}) {
    const Values nearest = ssv(scene, ":texture=" + side + ",words=float");
    const Values linear = ssv(scene, ":texture=" + side + ",words=float,filter=quadlinear");
    std::cout << "side " << side << ": RMSE " << rmse(nearest, exact) << ", largest "
              << largest(nearest, exact) << "; quadlinear " << rmse(linear, exact) << ", "
              << largest(linear, exact) << '\n';
    EXPECT_LT(rmse(nearest, exact), 0.75 * before);
    EXPECT_LT(rmse(linear, exact), 0.6 * rmse(nearest, exact));
    before = rmse(nearest, exact);
  }
  EXPECT_GT(largest(ssv(scene, ":texture=8"), exact), 16.0 / 255.0);
}

// 64 levels, and each contribution is off by half of one.
TEST(SsvTexture, ShortWordsHave64Levels) {
  const Scene scene = scene_of("cylinder", false, 192, 128);
  const Values exact = ssv(scene);
  const Values words = ssv(scene, ":vbuffer=8bit");
  std::set<int> levels;
  for (const float value : words) {
    const float level = value * ShortWord::kWhole;
    ASSERT_NEAR(level, std::round(level), 1e-3F);
    if (level > 0.0F && level < 63.0F) levels.insert(static_cast<int>(std::round(level)));
  }
  EXPECT_GT(levels.size(), 40U);
  EXPECT_LE(levels.size(), 62U);
  std::cout << levels.size() << " levels, RMSE " << rmse(words, exact) << ", largest error "
            << largest(words, exact) << '\n';
  EXPECT_GT(largest(words, exact), 0.5 / 63.0) << "it does not show";
  EXPECT_LT(rmse(words, exact), 1.0 / 63.0);
  const double table = largest(ssv(scene, ":vbuffer=8bit,texture=64,filter=quadlinear"), words);
  EXPECT_LE(table, 4.0 / 63.0) << "each of some edges by a level";
}

// A fence of 40 pickets under a wide light.
Scene fence() {
  Scene scene;
  scene.width = 64;
  scene.height = 48;
  scene.camera.eye = {0.0, 6.0, 6.0};
  scene.light.centre = {0.0, 8.0, 0.0};
  scene.light.half_u = {2.0, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 1.0};
  Object floor;
  floor.mesh = make_plane({8.0, 8.0}, {1, 1});
  scene.objects.push_back(floor);
  for (int i = 0; i < 40; ++i) {
    Object picket;
    picket.casts = true;
    picket.mesh = make_box({0.04, 0.02, 3.0});
    for (glm::dvec3& p : picket.mesh.positions) p += glm::dvec3(0.08 * (i - 19.5), 4.0, 0.0);
    scene.objects.push_back(picket);
  }
  return scene;
}

// The artifact v-buffer-overflow: more than 255 / 63 of a light is added to a pixel, and as much is
// taken: both stay at 255.
TEST(SsvTexture, ShortWordsOverflow) {
  const Scene scene = fence();
  const Values exact = ssv(scene);
  const Values words = ssv(scene, ":vbuffer=8bit");
  const std::size_t middle = 24 * 64 + 32;
  std::cout << "exact " << exact[middle] << ", in short words " << words[middle] << '\n';
  EXPECT_NEAR(exact[middle], 0.5, 0.05) << "every other part of the light is hidden";
  EXPECT_GT(std::abs(words[middle] - exact[middle]), 0.3F);
}

TEST(SsvTexture, AccessesCountLookups) {
  const Scene scene = scene_of("plain-columns", true);
  const auto of = [&](const std::string& options) {
    return render_view(scene, choose_method("", "ssv" + options)).visibility.accesses;
  };
  const MethodAccesses exact = of("");
  const MethodAccesses nearest = of(":texture=32");
  const MethodAccesses linear = of(":texture=32,filter=quadlinear");
  EXPECT_EQ(exact.map_reads, 0U);
  EXPECT_GT(nearest.map_reads, 100U);
  EXPECT_EQ(linear.map_reads, 16 * nearest.map_reads);
  EXPECT_EQ(nearest.bytes, exact.bytes + 3 * nearest.map_reads);
  EXPECT_EQ(nearest.li_writes, exact.li_writes);
}

TEST(SsvTexture, WhatThePaperDoesNotTreatIsRefused) {
  const auto refused = [](const Scene& scene, const std::string& options) {
    try {
      ssv(scene, options);
    } catch (const InputError& error) {
      return std::string(error.what());
    }
    return std::string();
  };
  SceneOptions sphere;
  sphere.size = {8, 8};
  sphere.light_shape = LightShape::sphere;
  EXPECT_NE(refused(load_scene("plain-columns", sphere), ":texture=32").find("rectangular light"),
            std::string::npos);
  EXPECT_NE(refused(scene_of("fire", true), ":vbuffer=8bit").find("hold no colours"),
            std::string::npos);
  EXPECT_NE(refused(scene_of("fire", true), ":texture=9").find("one of none, 8"),
            std::string::npos);
}

}  // namespace
}  // namespace wedgesim::functional
