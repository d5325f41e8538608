// Do published times stand beside the run of ours that is nearest to them?
#include "reports/accuracy/published.h"

#include <gtest/gtest.h>

namespace wedgesim::reports::accuracy {
namespace {

SceneResult measured(const std::string& scene, std::size_t triangles, int edge,
                     const std::string& choice, double milliseconds) {
  SceneResult result;
  result.scene.name = scene;
  result.scene.width = result.scene.height = edge;
  result.triangles = triangles;
  result.reference.emplace_back();
  Measured& one = result.methods.emplace_back();
  one.choice = functional::choose_method("", choice);
  one.timing.all_threads = 1e-3 * milliseconds;
  return result;
}

const Beside* find(const std::vector<Beside>& all, std::string_view scene, int edge) {
  for (const Beside& row : all) {
    if (row.published->scene == scene && row.published->width == edge) return &row;
  }
  return nullptr;
}

TEST(Published, NamesMethodsOfOursAndItsSource) {
  for (const Published& one : published()) {
    EXPECT_FALSE(one.paper.empty() || one.place.empty() || one.hardware.empty()) << one.scene;
    EXPECT_GT(one.frames_per_second, 0.0);
  }
}

// Table 1 of the occlusion camera says that its stages do not quite add up to the frame's time.
TEST(Published, StagesAreNoLongerThanAFrameByMuch) {
  for (const Published& one : published()) {
    double sum = 0.0;
    for (const PublishedStage& stage : one.stages) sum += stage.milliseconds;
    if (sum == 0.0) continue;
    EXPECT_GT(sum, 0.75 * one.milliseconds()) << one.scene;
    EXPECT_LT(sum, 2.2 * one.milliseconds()) << one.scene;
  }
}

TEST(Published, StandsBesideTheNearestSize) {
  const std::vector<SceneResult> results{measured("small", 200, 300, "d-buffer", 2.0),
                                         measured("large", 6000, 300, "d-buffer", 20.0),
                                         measured("other", 224, 300, "hard", 0.1)};
  const auto all = beside_published(results);
  ASSERT_EQ(all.size(), 12U) << "of the D-buffer alone";
  const Beside* small = find(all, "Varying distance", 300);
  ASSERT_NE(small, nullptr);
  EXPECT_EQ(small->scene->scene.name, "small");
  EXPECT_TRUE(small->comparable);
  EXPECT_EQ(find(all, "Complex caster", 300)->scene->scene.name, "large");
  EXPECT_FALSE(find(all, "Varying distance", 1000)->comparable) << "eleven times the pixels";
  const std::string text = published_text(results);
  EXPECT_NE(text.find("PC of 3 GHz, Quadro FX 3000, 2004"), std::string::npos) << text;
  EXPECT_EQ(text.find("1000x1000"), std::string::npos) << text;
  const Json json = published_json(results);
  EXPECT_EQ(json[0]["year"], 2004);
  EXPECT_EQ(json[0]["ours"]["timing"]["all_threads_ms"], 2.0);
  EXPECT_NEAR(json[0]["ms"].get<double>(), 1e3 / 212.0, 1e-9);
}

TEST(Published, TheSceneMadeAfterItComesFirst) {
  const std::vector<SceneResult> results{
      measured("mesh", 70000, 512, "occlusion-camera", 30.0),
      measured("bunny 640x427", 69000, 600, "occlusion-camera", 5.0)};
  const auto all = beside_published(results);
  const Beside* bunny = find(all, "Bunny", 512);
  ASSERT_NE(bunny, nullptr);
  EXPECT_EQ(bunny->scene->scene.name, "bunny 640x427");
  EXPECT_TRUE(bunny->comparable);
  EXPECT_EQ(find(all, "Venus and sphere", 512)->scene->scene.name, "mesh");
}

TEST(Published, NothingIsSaidWithoutTheMethod) {
  const std::vector<SceneResult> results{measured("s", 224, 300, "hard", 1.0)};
  EXPECT_EQ(published_text(results), "");
  EXPECT_EQ(published_html(results), "");
  EXPECT_TRUE(published_json(results).empty());
}

}  // namespace
}  // namespace wedgesim::reports::accuracy
