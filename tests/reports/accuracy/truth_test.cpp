#include "reports/accuracy/truth.h"

#include <gtest/gtest.h>

#include "functional/reference/reference.h"
#include "functional/scene/scene_file.h"
#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy {
namespace {

TEST(ReferenceWhereItMatters, IsTheFullReferenceInAndAroundPenumbrae) {
  functional::SceneOptions options;
  options.size = {96, 64};
  const functional::Scene scene = functional::load_scene("plain-columns", options);
  const auto window = functional::make_window(scene.camera, scene.width, scene.height);
  const auto depth =
      functional::render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  const std::vector<float> full =
      functional::reference_visibility(scene, window, depth, 1024, kTruthSeed);
  const std::vector<float> sparing = reference_where_it_matters(scene, window, depth, 1024);
  std::size_t penumbra = 0;
  std::size_t wrong = 0;
  for (std::size_t i = 0; i < full.size(); ++i) {
    const bool partly = full[i] > 0.02F && full[i] < 0.98F;
    if (partly) {
      ++penumbra;
      EXPECT_EQ(sparing[i], full[i]) << i;
    }
    if (sparing[i] != full[i]) ++wrong;
  }
  EXPECT_GT(penumbra, 100U);
  EXPECT_LE(wrong, full.size() / 200);
}

// Rays are not held against themselves: with as many of others, both errors add up.
TEST(ReferenceWhereItMatters, IsOfRaysOfItsOwn) {
  functional::SceneOptions options;
  options.size = {96, 64};
  const functional::Scene scene = functional::load_scene("plain-columns", options);
  const auto rmse = [&](int rays) {
    const MeasureOptions measured{
        .choices = {functional::choose_method("", "raytraced-64")}, .rays = rays, .repetitions = 1};
    return measure(scene, measured).methods.front().on(Region::penumbra).rmse;
  };
  EXPECT_GT(rmse(64), 1.2 * rmse(4096));
  EXPECT_LT(rmse(64), 1.6 * rmse(4096));
}

TEST(ReferenceVisibility, TracesOnlyWantedPixels) {
  functional::SceneOptions options;
  options.size = {32, 24};
  const functional::Scene scene = functional::load_scene("plain-columns", options);
  const auto window = functional::make_window(scene.camera, scene.width, scene.height);
  const auto depth =
      functional::render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  const std::vector<float> full = functional::reference_visibility(scene, window, depth, 16);
  std::vector<std::uint8_t> wanted(full.size(), 0);
  std::size_t dark = 0;
  for (std::size_t i = 0; i < full.size(); i += 2) wanted[i] = 1;
  const std::vector<float> half =
      functional::reference_visibility(scene, window, depth, 16, 1, wanted);
  for (std::size_t i = 0; i < full.size(); ++i) {
    EXPECT_EQ(half[i], wanted[i] != 0 ? full[i] : 1.0F) << i;
    if (full[i] < 1.0F) ++dark;
  }
  EXPECT_GT(dark, 20U);
}

}  // namespace
}  // namespace wedgesim::reports::accuracy
