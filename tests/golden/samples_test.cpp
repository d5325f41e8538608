// Are the sample traces still readable, and does the block still count the same in them?
// docs/testing.md tells how to refresh them and their counters.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <fstream>
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "base/file.h"
#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "functional/scene/skin.h"
#include "model/count/count.h"
#include "tests/golden/golden.h"
#include "tests/support/hand_worked_scene.h"
#include "traces/reader.h"
#include "traces/writer.h"

namespace wedgesim::tests {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::uintmax_t kMostBytes = 64 * 1024;

std::filesystem::path samples_folder() { return WEDGESIM_SOURCE_DIR "/traces/samples"; }

struct Sample {
  std::string name;
  functional::Scene (*scene)();
  functional::FrameOptions options;
};

functional::Scene small(const std::string& name, functional::SceneOptions options = {}) {
  options.size = {32, 24};
  return functional::load_scene(name, options);
}

// With fewer segments than the scene's, or the file is too large.
functional::Scene cylinder_under_a_sphere() {
  functional::SceneOptions options;
  options.light_shape = functional::LightShape::sphere;
  functional::Scene scene = small("cylinder", options);
  functional::Mesh& mesh = scene.objects.back().mesh;
  const std::string name = mesh.name;
  mesh = functional::make_lathe({{0.6, -0.02}, {0.6, 2.0}}, 24);
  mesh.name = name;
  return scene;
}

// Without the ball, or the file is too large.
functional::Scene eye_in_shadow() {
  functional::Scene scene = small("eye-in-shadow");
  std::erase_if(scene.objects, [](const auto& object) { return object.mesh.name == "ball"; });
  return scene;
}

std::vector<Sample> samples() {
  functional::FrameOptions linear;
  linear.kind = traces::fb::WedgeKind_linear;
  linear.depth_format = traces::fb::DepthFormat_float32;
  return {{"hand-worked", hand_worked_scene, {}},
          {"ground-polygon", [] { return small("ground-polygon"); }, {}},
          {"cylinder-sphere", cylinder_under_a_sphere, {}},
          {"overlap-linear", [] { return small("overlap"); }, linear},
          {"eye-in-shadow", eye_in_shadow, {}}};
}

std::filesystem::path path_of(const Sample& sample) {
  return samples_folder() / (sample.name + ".wtrace");
}

// What the block does with a sample in tiles of 4, by the defaults of `count` otherwise.
Json counted(const traces::TraceView& trace) {
  model::CountConfig config;
  config.tile = 4;
  const auto results = model::count(trace, {&config, 1});
  const model::CountResult& result = results.front();
  Json counters;
  for (const Counter* counter : result.counters->counters()) {
    counters[std::string(counter->name())] = counter->value();
  }
  return {
      {"trace",
       {{"checksum", fmt::format("{:016x}", trace.header.checksum)},
        {"width", trace.header.width},
        {"height", trace.header.height},
        {"wedges", trace.wedges.size()}}},
      {"z", result.z == model::ZMethod::pass ? "pass" : "fail"},
      {"counters", std::move(counters)},
      {"pixels", {{"compared", result.pixels.compared}, {"mismatched", result.pixels.mismatched}}}};
}

Json golden_counters() {
  std::ifstream file(golden_folder() / "samples.json");
  return Json::parse(file);
}

// One line for each key whose values differ.
void expect_equal(const Json& is, const Json& golden) {
  const Json is_flat = is.flatten();
  const Json golden_flat = golden.flatten();
  for (const auto& [key, value] : is_flat.items()) {
    const Json expected = golden_flat.contains(key) ? golden_flat[key] : Json("missing");
    EXPECT_TRUE(value == expected) << key << " is " << value << ", golden " << expected;
  }
  for (const auto& [key, value] : golden_flat.items()) {
    EXPECT_TRUE(is_flat.contains(key)) << key << " is missing, golden " << value;
  }
}

TEST(Samples, AreReadAndCountedAsBefore) {
  if (updates_golden()) {
    Json all;
    for (const Sample& sample : samples()) {
      traces::write_trace(path_of(sample),
                          functional::make_frame(sample.scene(), sample.options).trace);
      all[sample.name] = counted(traces::TraceFile(path_of(sample)).view());
    }
    write_file(golden_folder() / "samples.json", all.dump(1) + "\n");
  }
  const Json golden = golden_counters();
  EXPECT_EQ(golden.size(), samples().size());
  for (const Sample& sample : samples()) {
    SCOPED_TRACE(sample.name);
    const traces::TraceFile file(path_of(sample));
    EXPECT_LE(std::filesystem::file_size(path_of(sample)), kMostBytes);
    const Json is = counted(file.view());
    EXPECT_EQ(is["pixels"]["compared"], file.view().depth.size());
    EXPECT_EQ(is["pixels"]["mismatched"], 0);
    expect_equal(is, golden.value(sample.name, Json::object()));
  }
}

TEST(Samples, AreAllOfTheFolder) {
  const std::vector<Sample> all = samples();
  for (const auto& entry : std::filesystem::directory_iterator(samples_folder())) {
    EXPECT_TRUE(std::any_of(all.begin(), all.end(), [&](const Sample& sample) {
      return path_of(sample) == entry.path();
    })) << entry.path();
  }
}

}  // namespace
}  // namespace wedgesim::tests
