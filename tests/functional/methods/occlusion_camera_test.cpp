// Where is the occlusion camera right, and where does it fail as its paper says? Small scenes of
// boxes over a floor against ray-traced visibility.
#include "functional/methods/occlusion_camera.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <string>

#include "base/error.h"
#include "functional/methods/render.h"
#include "functional/reference/reference.h"
#include "functional/scene/primitives.h"
#include "functional/scene/transform.h"
#include "tests/functional/methods/instruction_sets.h"

namespace wedgesim::functional {
namespace {

constexpr int kRays = 256;

// A floor at y = 0, seen from above, under a spherical light at (0.6, 8, 0.3).
Scene floor_scene(double radius) {
  Scene scene;
  scene.width = 200;
  scene.height = 200;
  scene.camera.eye = {0.0, 9.0, 6.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.field_of_view_degrees = 36.0;
  scene.light.shape = LightShape::sphere;
  scene.light.centre = {0.6, 8.0, 0.3};
  scene.light.radius = radius;
  scene.objects.push_back({make_plane({20.0, 20.0}, {2, 2}), false});
  return scene;
}

void add_box(Scene& scene, const glm::dvec3& size, const glm::dvec3& position,
             const glm::dvec3& turn_degrees = glm::dvec3(0.0)) {
  scene.objects.push_back(
      {placed(make_box(size), {.turn_degrees = turn_degrees, .position = position}), true});
}

// A frame of a scene with its truth.
struct Frame {
  explicit Frame(Scene s)
      : scene(std::move(s)),
        window(make_window(scene.camera, scene.width, scene.height)),
        depth(render_depth(window, scene.objects, traces::fb::DepthFormat_float32)),
        truth(reference_visibility(scene, window, depth, kRays)) {}

  Visibility render(const std::string& options = "") const {
    const std::string name = "occlusion-camera";
    return render_method({scene, window, depth},
                         choose_method("", options.empty() ? name : name + ":" + options));
  }
  std::vector<float> values(const std::string& options = "") const {
    return render(options).values;
  }
  bool receives(std::size_t pixel) const {
    return depth.triangle[pixel] != DepthBuffer::kSky &&
           !scene.objects[depth.surface(pixel).object].casts;
  }
  // Of receivers; of the penumbra's pixels alone.
  double rmse(const std::vector<float>& values, bool penumbra = false) const {
    double sum = 0.0;
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (!receives(i) || (penumbra && (truth[i] == 0.0F || truth[i] == 1.0F))) continue;
      const double error = static_cast<double>(values[i]) - static_cast<double>(truth[i]);
      sum += error * error;
      ++pixels;
    }
    return std::sqrt(sum / static_cast<double>(std::max<std::size_t>(1, pixels)));
  }
  // Receivers' pixels that are brighter than the truth by more than `more`; darker if it is below
  // 0.
  std::size_t off(const std::vector<float>& values, float more) const {
    std::size_t pixels = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      const float error = values[i] - truth[i];
      if (receives(i) && (more > 0.0F ? error > more : error < more)) ++pixels;
    }
    return pixels;
  }

  Scene scene;
  Window window;
  DepthBuffer depth;
  std::vector<float> truth;
};

const Frame& one_box() {
  static const Frame frame = [] {
    Scene scene = floor_scene(0.25);
    add_box(scene, {1.6, 0.4, 1.2}, {0.0, 1.5, 0.0}, {0.0, 25.0, 0.0});
    return Frame(std::move(scene));
  }();
  return frame;
}

// Bars beside each other.
Frame comb(double radius, int bars, double width, double gap) {
  Scene scene = floor_scene(radius);
  for (int i = 0; i < bars; ++i) {
    add_box(scene, {width, 0.12, 2.4}, {(i - 0.5 * (bars - 1)) * (width + gap), 2.0, 0.0});
  }
  return Frame(std::move(scene));
}

// The curve 3t² − 2t³ in the place of a disc's area is up to 0.04 off; the rest is the caster's
// corners, where the nearest edge stands for both.
TEST(OcclusionCamera, OneConvexCasterAndASmallLightAreNearlyRight) {
  const Frame& frame = one_box();
  const std::vector<float> values = frame.values();
  EXPECT_LE(frame.rmse(values), 0.005);
  EXPECT_LE(frame.rmse(values, true), 0.037);
  EXPECT_LE(frame.off(values, 0.1F), 0U);
  EXPECT_LE(frame.off(values, -0.1F), 15U);
}

// Where the truth is lit or dark throughout a few pixels, as many as a texel is wide, the method
// has no penumbra, and where it is neither the method has one.
TEST(OcclusionCamera, PenumbraeEndWithinATexel) {
  const Frame& frame = one_box();
  const std::vector<float> values = frame.values("resolution=256");
  constexpr int kTexel = 2;  // pixels: 0.0203 world units on the floor against 0.0265
  std::size_t grey = 0;
  for (int y = kTexel; y < frame.scene.height - kTexel; ++y) {
    for (int x = kTexel; x < frame.scene.width - kTexel; ++x) {
      const auto pixel = static_cast<std::size_t>(y * frame.scene.width + x);
      if (!frame.receives(pixel)) continue;
      float low = 1.0F;
      float high = 0.0F;
      bool floor = true;
      for (int dy = -kTexel; dy <= kTexel; ++dy) {
        for (int dx = -kTexel; dx <= kTexel; ++dx) {
          const auto near = static_cast<std::size_t>((y + dy) * frame.scene.width + x + dx);
          floor = floor && frame.receives(near);
          low = std::min(low, frame.truth[near]);
          high = std::max(high, frame.truth[near]);
        }
      }
      if (!floor) continue;
      if (low == 1.0F) {
        EXPECT_GT(values[pixel], 0.998F) << x << " " << y;
      }
      if (high == 0.0F) {
        EXPECT_LT(values[pixel], 0.002F) << x << " " << y;
      }
      if (frame.truth[pixel] > 0.1F && frame.truth[pixel] < 0.9F) {
        ++grey;
        EXPECT_GT(values[pixel], 0.0F) << x << " " << y;
        EXPECT_LT(values[pixel], 1.0F) << x << " " << y;
      }
    }
  }
  EXPECT_GT(grey, 200U);
}

// A light of a length and no width is one too.
TEST(OcclusionCamera, APointCastsTheShadowOfARay) {
  Frame frame = one_box();
  frame.scene.light.shape = LightShape::point;
  frame.scene.light.radius = 0.0;
  frame.scene.light.half_v = {0.0, 0.0, 0.8};
  frame.truth = reference_visibility(frame.scene, frame.window, frame.depth, 1);
  const std::vector<float> values = frame.values("texels=1");
  std::size_t different = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    EXPECT_TRUE(values[i] == 0.0F || values[i] == 1.0F) << i;
    if (frame.receives(i) && values[i] != frame.truth[i]) ++different;
  }
  EXPECT_LE(different, 12U);  // along about 200 pixels of outline
  frame.scene.light.shape = LightShape::rectangle;
  EXPECT_EQ(frame.values("texels=1"), values);
}

TEST(OcclusionCamera, ARectangleIsTheSphereThatItBecomes) {
  Frame frame = one_box();
  const std::vector<float> sphere = frame.values();
  frame.scene.light.shape = LightShape::rectangle;
  frame.scene.light.half_u = {0.3, 0.0, 0.0};
  frame.scene.light.half_v = {0.0, 0.0, 0.2};
  EXPECT_EQ(frame.values(), sphere);
}

TEST(OcclusionCamera, ThreadsDoNotShowInTheResult) {
  const Frame frame = comb(0.2, 5, 0.3, 0.2);
  const Visibility many = frame.render();
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Visibility single = frame.render();
  EXPECT_EQ(single.values, many.values);
  EXPECT_EQ(single.accesses.map_reads, many.accesses.map_reads);
  EXPECT_EQ(single.accesses.map_writes, many.accesses.map_writes);
  EXPECT_EQ(single.accesses.bytes, many.accesses.bytes);
}

TEST(OcclusionCamera, DoesNotDependOnTheInstructionSet) {
  const Frame frame = comb(0.2, 5, 0.3, 0.2);
  for (const char* options : {"resolution=301", "resolution=150,texels=1,maps=1"}) {
    const std::vector<float> widest = frame.values(options);
    for_each_instruction_set([&](const char* name) {
      EXPECT_EQ(frame.values(options), widest) << options << ", " << name;
    });
  }
}

// Light that both of two neighbours take away is found by the second look alone.
TEST(Artifacts, OverlappingPenumbrae) {
  const Frame frame = comb(0.3, 4, 0.5, 0.12);
  const std::vector<float> once = frame.values("lookups=1");
  const std::vector<float> thrice = frame.values();
  const std::size_t bright = frame.off(once, 0.1F);
  EXPECT_GE(bright, 50U);
  EXPECT_LE(frame.off(thrice, 0.1F), bright / 3);
  EXPECT_LT(frame.rmse(thrice), 0.95 * frame.rmse(once));
}

// The larger the light, the more silhouettes meet in a texel, which holds one: wrong shadows, with
// steps where the nearest changes.
TEST(Artifacts, CrowdedDistortionMap) {
  const Frame small = comb(0.1, 9, 0.12, 0.18);
  const Frame large = comb(0.8, 9, 0.12, 0.18);
  EXPECT_LE(small.rmse(small.values(), true), 0.035);
  const std::vector<float> values = large.values();
  EXPECT_GE(large.rmse(values, true), 0.1);
  std::size_t steps = 0;
  for (std::size_t i = 1; i < values.size(); ++i) {
    if (!large.receives(i - 1) || !large.receives(i)) continue;
    if (std::abs(large.truth[i] - large.truth[i - 1]) < 0.04F &&
        std::abs(values[i] - values[i - 1]) > 0.1F) {
      ++steps;
    }
  }
  EXPECT_GE(steps, 50U);
}

// A roof so thin and steep that the place a ray is bent to is on a nearer part of the roof itself.
TEST(Artifacts, FalseShadows) {
  Scene scene = floor_scene(0.5);
  add_box(scene, {1.6, 0.1, 1.2}, {0.3, 4.0, 0.0});
  add_box(scene, {6.0, 0.05, 6.0}, {0.0, 0.0, 0.0}, {0.0, 0.0, 55.0});
  const Frame frame(std::move(scene));
  const auto falsely_dark = [&](const std::vector<float>& values) {
    std::size_t dark = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (frame.depth.triangle[i] == DepthBuffer::kSky) continue;
      if (frame.depth.surface(i).object != 2) continue;  // the roof
      if (values[i] < 0.01F && frame.truth[i] > 0.2F) ++dark;
    }
    return dark;
  };
  EXPECT_GE(falsely_dark(frame.values("bias=0")), 100U);
  EXPECT_LE(falsely_dark(frame.values()), 5U);
}

// Panes that cast no shadow, one above the caster and one below it.
TEST(OcclusionCamera, WhatCastsNoShadowKeepsNoLightFromWhatIsBehindIt) {
  Scene scene = one_box().scene;
  scene.camera.eye = {0.0, 3.5, 8.0};
  const Frame without(scene);
  const std::vector<float> values_without = without.values();
  for (const auto& [size, height] : {std::pair(20.0, 4.0), std::pair(3.0, 0.6)}) {
    scene.objects.push_back(
        {placed(make_plane({size, size}, {1, 1}), {.position = {1.0, height, 0.0}}), false});
  }
  const Frame frame(std::move(scene));
  const std::vector<float> values = frame.values();
  EXPECT_LE(frame.rmse(values), 0.005);
  EXPECT_LE(frame.rmse(values, true), 0.04);
  EXPECT_LE(frame.off(values, 0.1F), 0U);
  std::size_t seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (frame.receives(i) || frame.depth.triangle[i] == DepthBuffer::kSky) continue;
    ++seen;
    EXPECT_EQ(values[i], values_without[i]) << i;
  }
  EXPECT_GT(seen, 100U);
}

std::string error_of(const Scene& scene) {
  try {
    const Window window = make_window(scene.camera, scene.width, scene.height);
    render_method(
        {scene, window, render_depth(window, scene.objects, traces::fb::DepthFormat_float32)},
        choose_method("", "occlusion-camera"));
  } catch (const InputError& error) {
    return error.what();
  }
  return {};
}

TEST(OcclusionCamera, RefusesALightThatTouchesOrIsAmongCasters) {
  Scene touched = floor_scene(0.25);
  add_box(touched, {0.2, 0.2, 0.2}, {0.6, 7.9, 0.3});
  EXPECT_NE(error_of(touched).find("touches the light"), std::string::npos) << error_of(touched);
  Scene among = floor_scene(0.25);
  add_box(among, {0.2, 0.2, 0.2}, {0.6, 9.0, 0.3});
  add_box(among, {0.2, 0.2, 0.2}, {0.6, 6.0, 0.3});
  EXPECT_NE(error_of(among).find("half-space"), std::string::npos) << error_of(among);
}

// Two faces in one place, seen from above and lit: the eye's triangle may be the lower one.
TEST(OcclusionCamera, AThinCasterDoesNotShadowItself) {
  Scene scene = floor_scene(0.25);
  scene.objects.push_back(
      {placed(make_thin_polygon({{-1.0, -1.0}, {-1.3, 0.8}, {0.2, 1.2}, {1.1, -0.4}}),
              {.turn_degrees = {12.0, 0.0, -20.0}, .position = {0.0, 1.0, 0.0}}),
       true});
  const Frame frame(std::move(scene));
  const std::vector<float> values = frame.values();
  std::size_t seen = 0;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (frame.receives(i) || frame.depth.triangle[i] == DepthBuffer::kSky) continue;
    ++seen;
    EXPECT_GT(values[i], 0.99F) << i;
  }
  EXPECT_GT(seen, 1000U);
}

TEST(OcclusionCamera, NothingCastsNoShadow) {
  const Frame frame(floor_scene(0.25));
  for (const float value : frame.values()) EXPECT_EQ(value, 1.0F);
}

}  // namespace
}  // namespace wedgesim::functional
