#include "functional/methods/render.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>

#include "base/error.h"
#include "functional/scene/lights.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

struct Render : testing::Test {
  static Scene small_scene(const std::string& name) {
    SceneOptions options;
    options.size = {48, 32};
    return load_scene(name, options);
  }
  Scene scene = small_scene("plain-columns");
  Window window = make_window(scene.camera, scene.width, scene.height);
  DepthBuffer depth = render_depth(window, scene.objects, traces::fb::DepthFormat_float32);

  Image shaded(float visibility) const {
    return shade(scene, window, depth, std::vector<float>(depth.words.size(), visibility));
  }
};

TEST_F(Render, LightBrightensSurfacesButNotTheSky) {
  const Image lit = shaded(1.0F);
  const Image dark = shaded(0.0F);
  std::size_t brighter = 0;
  for (std::size_t i = 0; i < depth.words.size(); ++i) {
    const float* a = &lit.values[3 * i];
    const float* b = &dark.values[3 * i];
    if (depth.triangle[i] == DepthBuffer::kSky) {
      EXPECT_TRUE(std::equal(a, a + 3, b)) << i;
    } else {
      for (int c = 0; c < 3; ++c) EXPECT_GE(a[c], b[c]) << i;
      if (a[1] > b[1] + 0.1F) ++brighter;
    }
  }
  EXPECT_GT(brighter, depth.words.size() / 4);
}

TEST_F(Render, LightsAddUp) {
  Scene both = small_scene("two-lights");
  both.light.colour *= 0.3;  // nothing saturates
  both.other_lights[0].colour *= 0.3;
  const View view = render_view(both, choose_method("", "coverage"));
  ASSERT_EQ(view.other_visibility.size(), 1U);
  const Image lit = shade(both, view);
  const Scene second = with_light(both, 1);
  EXPECT_EQ(view.other_visibility[0].values,
            render_view(second, choose_method("", "coverage")).visibility.values);
  EXPECT_NE(view.other_visibility[0].values, view.visibility.values);
  const Image first_alone = shade(both, view.window, view.depth, view.visibility.values);
  const Image second_alone =
      shade(second, view.window, view.depth, view.other_visibility[0].values);
  const Image dark = shade(both, view.window, view.depth, std::vector<float>(48 * 32, 0.0F));
  for (std::size_t i = 0; i < lit.values.size(); ++i) {
    ASSERT_NEAR(lit.values[i], first_alone.values[i] + second_alone.values[i] - dark.values[i],
                1e-6F)
        << i;
  }
}

TEST_F(Render, ATexturedLightShinesInItsMeanColour) {
  scene.light.colour = {0.5, 0.5, 0.5};
  const Image plain = shaded(1.0F);
  Image texture(2, 1, 3);
  texture.values = {2, 1, 0, 0, 1, 0};  // the mean is (1, 1, 0)
  scene.light.texture = std::make_shared<const Image>(texture);
  const Image lit = shaded(1.0F);
  const Image dark = shaded(0.0F);
  const Image red = shade(scene, window, depth, [&] {
    std::vector<float> values(3 * depth.words.size(), 0.0F);
    for (std::size_t i = 0; i < values.size(); i += 3) values[i] = 1.0F;
    return values;
  }());
  for (std::size_t i = 0; i < lit.values.size(); i += 3) {
    ASSERT_FLOAT_EQ(lit.values[i], plain.values[i]);
    ASSERT_FLOAT_EQ(lit.values[i + 1], plain.values[i + 1]);
    ASSERT_FLOAT_EQ(lit.values[i + 2], dark.values[i + 2]);
    ASSERT_EQ(red.values[i], lit.values[i]);
    ASSERT_EQ(red.values[i + 1], dark.values[i + 1]);
  }
}

TEST_F(Render, VisibilityIsClamped) {
  EXPECT_EQ(shaded(1.5F).values, shaded(1.0F).values);
  EXPECT_EQ(shaded(-0.5F).values, shaded(0.0F).values);
  EXPECT_NE(shaded(0.5F).values, shaded(1.0F).values);
}

TEST_F(Render, AnotherNumberOfPixelsIsABug) {
  EXPECT_THROW(shade(scene, window, depth, {1.0F}), CheckError);
}

TEST_F(Render, EveryMethodSeesTheSameShadows) {
  const std::vector<float> reference =
      render_view(scene, choose_method("", "raytraced-256")).visibility.values;
  for (const Method& method : methods()) {
    const View view = render_view(scene, choose_method("", method.name));
    const std::vector<float>& values = view.visibility.values;
    ASSERT_EQ(values.size(), reference.size());
    std::size_t shadowed = 0;
    std::size_t agree = 0;
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (view.depth.triangle[i] == DepthBuffer::kSky || reference[i] > 0.02F) continue;
      const bool on_caster = scene.objects[view.depth.surface(i).object].casts;
      if (on_caster && method.name == "silhouette-rings") continue;  // a plane's shadows alone
      ++shadowed;
      if (values[i] < 0.1F) ++agree;
    }
    EXPECT_GT(shadowed, 20U);
    EXPECT_GE(agree, shadowed - shadowed / 20) << method.name;
  }
}

TEST(EncodeSrgb, FollowsTheStandardCurve) {
  Image linear(5, 1, 1);
  linear.values = {-1.0F, 0.002F, 0.2140411F, 1.0F, 3.0F};
  const std::array<float, 5> expected{0.0F, 0.02584F, 0.5F, 1.0F, 1.0F};
  const Image encoded = encode_srgb(linear);
  for (std::size_t i = 0; i < 5; ++i) EXPECT_NEAR(encoded.values[i], expected[i], 1e-5F) << i;
}

}  // namespace
}  // namespace wedgesim::functional
