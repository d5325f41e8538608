#include "reports/accuracy/claim_results.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "functional/scene/scene_file.h"
#include "reports/accuracy/views.h"
#include "reports/claims/claims.h"

namespace wedgesim::reports::accuracy {
namespace {

constexpr const char* kClaim = R"([[claim]]
id = "fewer-rays"
by = "accuracy"
paper = "P"
section = "1"
says = "fewer rays err more"
unit = "times"
band = [1, 100]
scenes = ["plain-columns"]
[[claim.measured]]
definition = "d"
kind = "ratio"
metric = "rmse"
from.method = "raytraced-4"
to.method = "raytraced-64"
[[claim.measured]]
definition = "with another scene"
kind = "ratio"
metric = "z_reads"
from.method = "raytraced-4"
from.scene = "twice as wide"
to.method = "raytraced-4"
[[claim.measured]]
definition = "alone"
kind = "value"
metric = "odd_degree_vertices"
to.method = "raytraced-4"
)";

SceneResult measured(const std::string& name, std::pair<int, int> size,
                     const std::vector<std::string>& choices) {
  functional::SceneOptions scene_options;
  scene_options.size = size;
  MeasureOptions options{.choices = {}, .rays = 256, .repetitions = 1};
  for (const std::string& text : choices) {
    options.choices.push_back(functional::choose_method("", text));
  }
  functional::Scene scene = functional::load_scene("plain-columns", scene_options);
  scene.name = name;
  return measure(scene, options);
}

TEST(ClaimResults, ClaimsAreMeasuredOnScenesAndPairsOfThem) {
  const ClaimFile claims = parse_claims(kClaim, "c.toml");
  const ClaimWork expected{{"plain-columns", {"raytraced-4", "raytraced-64"}},
                           {"twice as wide", {"raytraced-4"}}};
  EXPECT_EQ(work_of(claims), expected);
  const std::vector<SceneResult> scenes{
      measured("plain-columns", {40, 30}, {"raytraced-4", "raytraced-64"}),
      measured("twice as wide", {80, 30}, {"raytraced-4"})};
  const Results results = claim_results(scenes);
  const ClaimResult judged = judge_claims(claims, results).front();
  EXPECT_EQ(judged.verdict, Verdict::reproduced);
  const auto only = [&](std::size_t i) { return judged.measured[i].at("").spread.median; };
  EXPECT_DOUBLE_EQ(only(0), scenes[0].methods[0].on(Region::receivers).rmse /
                                scenes[0].methods[1].on(Region::receivers).rmse);
  EXPECT_DOUBLE_EQ(only(1), 2.0);
  EXPECT_DOUBLE_EQ(only(2), 0.0);
}

// Every claim about methods names scenes and choices that exist.
TEST(MethodClaims, CanBeMeasured) {
  const auto& views = built_in_views();
  for (const auto& [scene, choices] : work_of(method_claims())) {
    if (std::ranges::find(views, scene, &View::name) == views.end()) {
      EXPECT_NO_THROW(functional::scene_source(scene)) << scene;
    }
    for (const std::string& text : choices) {
      EXPECT_NO_THROW(functional::choose_method("", text)) << text;
    }
  }
}

}  // namespace
}  // namespace wedgesim::reports::accuracy
