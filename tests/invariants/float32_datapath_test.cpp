// The single-precision datapath on every built-in scene, both wedge kinds and lights: whatever it
// makes of a pixel, modes, cullings and tiles do not change it. Its errors are measured, not held
// to a bar.
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "functional/scene/scene_file.h"
#include "tests/support/invariants.h"

namespace wedgesim::tests {
namespace {

using functional::LightShape;
using model::DatapathKind;
using traces::fb::WedgeKind;

functional::Frame frame_of(const std::string& name, WedgeKind kind, LightShape light) {
  functional::SceneOptions options;
  options.size = {160, 107};
  options.light_shape = light;
  functional::FrameOptions frame_options;
  frame_options.kind = kind;
  return functional::make_frame(functional::load_scene(name, options), frame_options);
}

class Float32Datapath : public testing::TestWithParam<std::string> {};

TEST_P(Float32Datapath, GivesTheSameWordsInEveryConfiguration) {
  const std::string& name = GetParam();
  if (name == "bunny" && !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
    GTEST_SKIP() << "the package glmark2-data is not installed";
  }
  for (const WedgeKind kind : {WedgeKind::WedgeKind_coverage, WedgeKind::WedgeKind_linear}) {
    for (const LightShape light : {LightShape::rectangle, LightShape::sphere}) {
      if (name == "fire" && light == LightShape::sphere) continue;  // textured
      const functional::Frame frame = frame_of(name, kind, light);
      std::vector<std::int64_t> words;
      EXPECT_EQ(check_words(frame, DatapathKind::float32, model::ZChoice::automatic, false, words),
                "");
      if (kind == WedgeKind::WedgeKind_coverage && !frame.trace.header.z_fail_needed) {
        EXPECT_EQ(check_words(frame, DatapathKind::float32, model::ZChoice::fail, false, words),
                  "");
      }
      const model::CountConfig config;
      model::CountOptions options;
      options.maps = true;
      const auto exact = model::count(frame.trace.view(), {&config, 1}, options);
      options.datapath = DatapathKind::float32;
      const auto single = model::count(frame.trace.view(), {&config, 1}, options);
      EXPECT_NE(single[0].li, exact[0].li) << "not in single precision";
      const model::PixelCheck& pixels = single[0].pixels;
      std::cout << name << ' ' << EnumNameWedgeKind(kind)
                << (light == LightShape::sphere ? " sphere" : " rectangle") << ": RMS "
                << pixels.rms_error * 255.0 << "/255, in penumbrae " << pixels.rms_penumbra * 255.0
                << "/255, at most " << pixels.max_error * 255.0 << "/255, " << pixels.mismatched
                << " mismatched\n";
    }
  }
}

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const functional::SceneInfo& info : functional::built_in_scenes()) {
    if (info.name != "mesh") names.push_back(info.name);  // a template, for a user's mesh
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Float32Datapath, testing::ValuesIn(scenes()),
                         [](const auto& test) {
                           std::string name = test.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

}  // namespace
}  // namespace wedgesim::tests
