// Soft shadow volumes by tiles and in single precision: the same as the renderer's own wedges,
// which are evaluated pixel by pixel in double precision, whatever the options, threads and
// vectors.
#include "functional/methods/ssv.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string>

#include "base/error.h"
#include "functional/methods/render.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/methods/instruction_sets.h"

namespace wedgesim::functional {
namespace {

constexpr std::pair kSize{160, 107};

Visibility render_by(const Scene& scene, const std::string& method) {
  return render_view(scene, choose_method("test", method)).visibility;
}

Scene scene_of(const std::string& name, LightShape shape, int frame = 0) {
  SceneOptions options;
  options.size = kSize;
  options.light_shape = shape;
  options.frame = frame;
  Scene scene = load_scene(name, options);
  scene.light.texture.reset();  // ssv_texture_test.cpp
  return scene;
}

struct Difference {
  double largest = 0.0;  // of the pixels that differ by at most kSame
  int others = 0;        // pixels that differ by more
};
constexpr double kSame = 1e-4;

Difference compare(const std::vector<float>& a, const std::vector<float>& b) {
  Difference difference;
  EXPECT_EQ(a.size(), b.size());
  for (std::size_t i = 0; i < a.size(); ++i) {
    const double d = std::abs(static_cast<double>(a[i]) - static_cast<double>(b[i]));
    if (d <= kSame) {
      difference.largest = std::max(difference.largest, d);
    } else {
      ++difference.others;
    }
  }
  return difference;
}

// The renderer's values without the sky, where z-pass and z-fail differ: 1 there.
std::vector<float> coverage_of(const Scene& scene) {
  const View view = render_view(scene, choose_method("test", "coverage"));
  std::vector<float> values = view.visibility.values;
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (view.depth.triangle[i] == DepthBuffer::kSky) values[i] = 1.0F;
  }
  return values;
}

class SsvScenes : public testing::TestWithParam<std::tuple<std::string, LightShape>> {
 protected:
  void SetUp() override {
    if (std::get<0>(GetParam()) == "bunny" &&
        !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
      GTEST_SKIP() << "the package glmark2-data is not installed";
    }
    if (GetParam() == std::tuple("fire", LightShape::sphere)) {
      GTEST_SKIP() << "its light's texture wants a rectangle";
    }
  }
};

std::vector<std::string> scene_names() {
  std::vector<std::string> names;
  for (const SceneInfo& info : built_in_scenes()) names.push_back(info.name);
  return names;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, SsvScenes,
                         testing::Combine(testing::ValuesIn(scene_names()),
                                          testing::Values(LightShape::rectangle,
                                                          LightShape::sphere)),
                         [](const auto& parameter) {
                           std::string name = std::get<0>(parameter.param);
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name + (std::get<1>(parameter.param) == LightShape::rectangle
                                              ? "_rectangle"
                                              : "_sphere");
                         });

// Pixels where single precision puts a point on the other side of a plane: an edge that points at
// the light, a surface that lies in a shadow quad.
constexpr int kMostOthers = 4;

TEST_P(SsvScenes, IsTheRenderersCoverage) {
  const auto& [name, shape] = GetParam();
  const int last = scene_of(name, shape).frames - 1;
  for (const int frame : {0, last / 2, last}) {
    const Scene scene = scene_of(name, shape, frame);
    const Difference difference = compare(render_by(scene, "ssv").values, coverage_of(scene));
    std::cout << name << " frame " << frame << ": largest difference " << difference.largest << ", "
              << difference.others << " pixels differ by more than " << kSame << '\n';
    EXPECT_LE(difference.others, kMostOthers) << "frame " << frame;
  }
}

TEST_P(SsvScenes, CullingChangesNothing) {
  const Scene scene = scene_of(std::get<0>(GetParam()), std::get<1>(GetParam()));
  EXPECT_EQ(
      compare(render_by(scene, "ssv").values, render_by(scene, "ssv:cull=none").values).others, 0);
}

TEST_P(SsvScenes, ZPassIsZFail) {
  const Scene scene = scene_of(std::get<0>(GetParam()), std::get<1>(GetParam()));
  std::vector<float> pass;
  try {
    pass = render_by(scene, "ssv:z=pass").values;
  } catch (const InputError&) {
    EXPECT_EQ(std::get<0>(GetParam()), "eye-in-shadow");
    return;
  }
  EXPECT_LE(compare(pass, render_by(scene, "ssv:z=fail").values).others, 0);
}

TEST(Ssv, DoesNotDependOnTheThreads) {
  const Scene scene = scene_of("text2002", LightShape::rectangle);
  const Visibility many = render_by(scene, "ssv");
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  const Visibility alone = render_by(scene, "ssv");
  EXPECT_EQ(many.values, alone.values);
  EXPECT_EQ(many.accesses.z_reads, alone.accesses.z_reads);
  EXPECT_EQ(many.accesses.li_writes, alone.accesses.li_writes);
}

void expect_same_by_all_instruction_sets(const Scene& scene, const std::string& method) {
  const std::vector<float> widest = render_by(scene, method).values;
  for_each_instruction_set([&](const char* name) {
    EXPECT_EQ(render_by(scene, method).values, widest) << method << ' ' << name;
  });
}

TEST(Ssv, DoesNotDependOnTheInstructionSet) {
  for (const LightShape shape : {LightShape::rectangle, LightShape::sphere}) {
    const Scene scene = scene_of("fractal", shape);
    for (const char* method : {"ssv", "ssv:vbuffer=8bit", "ssv-optimized:shader=tables",
                               "ssv-optimized:shader=tables,vbuffer=12bit"}) {
      expect_same_by_all_instruction_sets(scene, method);
    }
  }
  SceneOptions options;
  options.size = {80, 54};
  const Scene fire = load_scene("fire", options);
  for (const char* method : {"ssv", "ssv:texture=16", "ssv:texture=16,filter=quadlinear"}) {
    expect_same_by_all_instruction_sets(fire, method);
  }
  const Scene even = scene_of("fractal", LightShape::rectangle);
  expect_same_by_all_instruction_sets(even, "ssv:texture=16,filter=quadlinear");
}

TEST(Ssv, CountsWhatItReadsAndWrites) {
  const Visibility result = render_by(scene_of("plain-columns", LightShape::rectangle), "ssv");
  EXPECT_GT(result.accesses.z_reads, 0U);
  EXPECT_EQ(result.accesses.li_reads, result.accesses.li_writes);
  EXPECT_EQ(result.accesses.bytes, 4 * (result.accesses.z_reads + 2 * result.accesses.li_writes));
  std::vector<std::string> stages;
  for (const Stage& stage : result.stages) stages.push_back(stage.name);
  EXPECT_EQ(stages, (std::vector<std::string>{"tiles", "silhouettes", "volumes", "pixels"}));
}

}  // namespace
}  // namespace wedgesim::functional
