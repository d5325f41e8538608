// Do the invariants hold on every built-in scene, for both wedge kinds and lights, from many views?
#include <gtest/gtest.h>

#include <filesystem>
#include <iostream>

#include "functional/scene/scene_file.h"
#include "tests/support/invariants.h"

namespace wedgesim::tests {
namespace {

using traces::fb::WedgeKind;

struct Case {
  std::string scene;
  WedgeKind kind;
};

void PrintTo(const Case& c, std::ostream* out) { *out << c.scene; }

std::vector<Case> cases() {
  std::vector<Case> all;
  for (const functional::SceneInfo& info : functional::built_in_scenes()) {
    if (info.name == "mesh") continue;  // a template, for a user's mesh
    all.push_back({info.name, WedgeKind::WedgeKind_coverage});
    all.push_back({info.name, WedgeKind::WedgeKind_linear});
  }
  return all;
}

class Scenes : public testing::TestWithParam<Case> {};

TEST_P(Scenes, HoldTheInvariants) {
  const auto& [name, kind] = GetParam();
  if (name == "bunny" && !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
    GTEST_SKIP() << "the package glmark2-data is not installed";
  }
  const bool coverage = kind == WedgeKind::WedgeKind_coverage;
  functional::FrameOptions options;
  options.kind = kind;
  std::size_t most = 0;
  const auto check = [&](const functional::SceneOptions& scene_options, bool every_config) {
    std::vector<std::string> notes;
    const InvariantReport report = check_invariants(
        functional::load_scene(name, scene_options, &notes), options, every_config);
    EXPECT_EQ(report.failure, "") << "frame " << scene_options.frame;
    most = std::max(most, report.witness_pixels);
  };
  functional::SceneOptions scene_options;
  check(scene_options, false);
  scene_options.size = {160, 107};
  check(scene_options, true);
  if (name != "fire") {  // textured
    scene_options.light_shape = functional::LightShape::sphere;
    check(scene_options, false);
  }
  scene_options.light_shape.reset();
  for (const int frame : {10, 20}) {
    scene_options.frame = frame;
    check(scene_options, false);
  }
  EXPECT_LE(most, coverage ? 8U : 20U);
  std::cout << name << ": most pixels that differ from the witness " << most << '\n';
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, Scenes, testing::ValuesIn(cases()), [](const auto& test) {
  std::string name =
      test.param.scene + (test.param.kind == WedgeKind::WedgeKind_linear ? "_linear" : "_coverage");
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace wedgesim::tests
