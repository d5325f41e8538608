#include "reports/accuracy/measure.h"

#include <gtest/gtest.h>

#include "functional/scene/lights.h"
#include "functional/scene/scene_file.h"
#include "reports/accuracy/accuracy_json.h"
#include "reports/accuracy/accuracy_text.h"
#include "reports/accuracy/peak_memory.h"

namespace wedgesim::reports::accuracy {
namespace {

SceneResult measured(const std::vector<std::string>& choices) {
  functional::SceneOptions scene_options;
  scene_options.size = {60, 40};
  MeasureOptions options{.choices = {}, .rays = 256, .repetitions = 1};
  for (const std::string& text : choices) {
    options.choices.push_back(functional::choose_method("--method", text));
  }
  return measure(functional::load_scene("plain-columns", scene_options), options);
}

TEST(Measure, SaysOfEachChoiceWhatItErrsAndCosts) {
  const SceneResult result = measured({"raytraced-4", "raytraced-64"});
  ASSERT_EQ(result.methods.size(), 2U);
  const Measured& few = result.methods[0];
  const Measured& more = result.methods[1];
  EXPECT_GT(few.on(Region::receivers).rmse, more.on(Region::receivers).rmse);
  EXPECT_GT(more.on(Region::penumbra).rmse, more.on(Region::surfaces).rmse);
  EXPECT_EQ(few.accesses.z_reads, 60U * 40U);
  EXPECT_GT(few.timing.one_thread, 0.0);
  EXPECT_GT(few.timing.all_threads, 0.0);
  ASSERT_EQ(few.timing.stages.size(), 1U);
  EXPECT_EQ(few.timing.stages[0].name, "pixels");
  EXPECT_EQ(few.visibility.at(0).size(), 60U * 40U);
}

TEST(Measure, ErrorsAndAccessesAreOfAllLights) {
  functional::SceneOptions scene_options;
  scene_options.size = {60, 40};
  const functional::Scene scene = functional::load_scene("two-lights", scene_options);
  ASSERT_EQ(functional::light_count(scene), 2U);
  const MeasureOptions options{
      .choices = {functional::choose_method("", "raytraced-4")}, .rays = 256, .repetitions = 1};
  const SceneResult both = measure(scene, options);
  std::array<SceneResult, 2> each;
  for (std::size_t i = 0; i < 2; ++i) each[i] = measure(functional::with_light(scene, i), options);
  const auto receivers = [](const SceneResult& result) {
    return result.methods[0].on(Region::receivers);
  };
  EXPECT_EQ(both.reference.size(), 2U);
  EXPECT_NE(each[0].reference, each[1].reference);
  EXPECT_EQ(both.methods[0].accesses.z_reads, 2U * 60U * 40U);
  EXPECT_EQ(receivers(both).values, 2 * receivers(each[0]).values);
  const double squares =
      std::pow(receivers(each[0]).rmse, 2) + std::pow(receivers(each[1]).rmse, 2);
  EXPECT_NEAR(receivers(both).rmse, std::sqrt(squares / 2.0), 1e-12);
}

TEST(Measure, TheSameRunTwiceGivesTheSameJsonButForTimings) {
  const std::vector<std::string> choices{"raytraced-4", "hard"};
  std::array<Json, 2> results;
  for (Json& json : results) {
    json = accuracy_json({}, {measured(choices)}, nullptr);
    for (Json& scene : json["scenes"]) {
      scene.erase("timing");
      for (Json& method : scene["methods"]) method.erase("timing");
    }
  }
  EXPECT_EQ(results[0], results[1]);
  EXPECT_EQ(results[0]["schema"], "wedgesim.accuracy/1");
}

TEST(Measure, WhatIsRefusedIsNamedWithItsReason) {
  SceneResult result = measured({"raytraced-4"});
  Measured& hard = result.methods.emplace_back();
  hard.choice = functional::choose_method("", "hard");
  hard.refused = "no plane";
  const Wish wish{.max_error = 1.0, .budget_seconds = {}};
  EXPECT_NE(accuracy_text(result, &wish).find("hard refused: no plane"), std::string::npos);
  const Json json = accuracy_json({}, {result}, &wish);
  EXPECT_EQ(json["scenes"][0]["methods"][1]["refused"], "no plane");
  EXPECT_FALSE(json["scenes"][0]["methods"][1].contains("errors"));
  EXPECT_EQ(json["scenes"][0]["timing"]["recommended"]["choice"], "raytraced-4");
}

TEST(PeakMemory, SeesWhatWasUsedAndGivenBack) {
  const PeakMemory memory;
  constexpr std::size_t kBytes = std::size_t{1} << 26;
  {
    const std::vector<char> used(kBytes, 'x');
    EXPECT_EQ(used[kBytes / 2], 'x');
  }
  if (memory.bytes() == 0) GTEST_SKIP() << "the system does not tell";
  EXPECT_GE(memory.bytes(), kBytes - kBytes / 100);  // the system counts pages in batches
  EXPECT_LT(memory.bytes(), 2 * kBytes);
}

}  // namespace
}  // namespace wedgesim::reports::accuracy
