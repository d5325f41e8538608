// Do soft shadows become hard ones as their light becomes a point, and at the point the same words?
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdint>
#include <glm/geometric.hpp>
#include <string>

#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "model/count/count.h"

namespace wedgesim {
namespace {

using functional::LightShape;
using traces::fb::WedgeKind;

struct Kind {
  WedgeKind wedges;
  LightShape light;
};

class SmallLights : public testing::TestWithParam<Kind> {};

INSTANTIATE_TEST_SUITE_P(Kinds, SmallLights,
                         testing::Values(Kind{WedgeKind::WedgeKind_coverage, LightShape::rectangle},
                                         Kind{WedgeKind::WedgeKind_coverage, LightShape::sphere},
                                         Kind{WedgeKind::WedgeKind_linear, LightShape::sphere}));

functional::Frame render(const std::string& name, const Kind& kind, double size) {
  functional::SceneOptions options;
  options.size = {96, 64};
  functional::Scene scene = functional::load_scene(name, options);
  const double radius = size * glm::length(scene.light.half_u);
  if (kind.light == LightShape::sphere || size == 0.0) {
    scene.light.shape = size == 0.0 ? LightShape::point : LightShape::sphere;
    scene.light.radius = radius;
  } else {
    scene.light.half_u *= size;
    scene.light.half_v *= size;
  }
  functional::FrameOptions frame_options;
  frame_options.kind = kind.wedges;
  return make_frame(scene, frame_options);
}

TEST_P(SmallLights, ConvergeToHardShadows) {
  for (const std::string name : {"plain-columns", "cylinder"}) {
    const functional::Frame hard = render(name, GetParam(), 0.0);
    double at_full_size = 0.0;
    for (int step = 0; step <= 20; step += 2) {
      const double size = std::exp2(-step);
      const functional::Frame soft = render(name, GetParam(), size);
      double difference = 0.0;
      for (std::size_t i = 0; i < hard.trace.expected_li.size(); ++i) {
        difference += std::fabs(soft.trace.expected_li[i] - hard.trace.expected_li[i]);
      }
      if (step == 0) at_full_size = difference;
      // As penumbrae narrow with the light. A pixel on the edge itself may stay half lit.
      EXPECT_LE(difference, 1.5 * size * at_full_size + 1.0) << name << " at " << size;
    }
    EXPECT_GT(at_full_size, 15.0) << name;
  }
}

TEST_P(SmallLights, OfNoRadiusGiveTheWordsOfHardShadows) {
  const functional::Frame hard = render("plain-columns", GetParam(), 0.0);
  EXPECT_TRUE(hard.trace.wedges.empty());
  for (const auto datapath : {model::DatapathKind::fixed, model::DatapathKind::exact}) {
    model::CountOptions options;
    options.maps = true;
    options.datapath = model::Datapath(datapath);
    const auto results = count(hard.trace.view(), std::array{model::CountConfig{}}, options);
    std::size_t dark = 0;
    for (std::size_t i = 0; i < hard.trace.expected_li.size(); ++i) {
      const auto word =
          static_cast<std::int64_t>(hard.trace.expected_li[i] * options.datapath.one());
      ASSERT_EQ(results.front().li[i], word) << "pixel " << i;
      dark += word == 0 ? 1 : 0;
    }
    EXPECT_GT(dark, 50U);
  }
}

}  // namespace
}  // namespace wedgesim
