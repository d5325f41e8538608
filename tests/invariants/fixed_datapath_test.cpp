// Does the fixed datapath hold its pixel bars on every built-in scene, for both wedge kinds and
// lights, from the scene's own view and from random ones? WEDGESIM_VIEWS says how many of those.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <glm/geometric.hpp>
#include <iostream>
#include <random>

#include "base/error.h"
#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "model/count/count.h"

namespace wedgesim::tests {
namespace {

using functional::LightShape;
using model::Accept;
using model::CountResult;
using model::Cull;
using model::Mode;
using model::Share;
using model::UmbraCull;
using model::ZChoice;
using traces::fb::WedgeKind;

constexpr double kMostRms = 0.25 / 255.0;
// Each contribution is rounded to 2^-11; beyond so many on one pixel that alone may pass kMostRms,
// and a wider LI word is what the bar is for.
constexpr std::uint64_t kMostOfNarrowLi = 48;
constexpr unsigned kSeed = 2004;

int random_views() {
  const char* text = std::getenv("WEDGESIM_VIEWS");
  return text ? std::atoi(text) : 2;
}

struct Combination {
  WedgeKind kind;
  LightShape light;
};
constexpr Combination kCombinations[]{
    {WedgeKind::WedgeKind_coverage, LightShape::rectangle},
    {WedgeKind::WedgeKind_linear, LightShape::rectangle},
    {WedgeKind::WedgeKind_coverage, LightShape::sphere},
    {WedgeKind::WedgeKind_linear, LightShape::sphere},
};

std::string name_of(const Combination& c) {
  return std::string(EnumNameWedgeKind(c.kind)) +
         (c.light == LightShape::sphere ? " sphere" : " rectangle");
}

// Each mode, tile, culling, acceptance and sharing at least once; z-fail wherever it gives the
// same.
std::vector<model::CountConfig> configs(ZChoice z) {
  std::vector<model::CountConfig> all{
      {},
      {.mode = Mode::three_pass},
      {.tile = 2, .cull = Cull::none, .umbra_cull = UmbraCull::none},
      {.tile = 32, .cull = Cull::sat, .accept = Accept::zmin, .share = Share::all},
      {.mode = Mode::three_pass, .tile = 32, .cull = Cull::sat, .accept = Accept::zmin},
      {.tile = 256, .accept = Accept::zmin},
      {.mode = Mode::three_pass, .tile = 256, .cull = Cull::none},
      {.mode = Mode::three_pass, .tile = 2},
      {.tile = 2, .cull = Cull::sat, .accept = Accept::zmin, .share = Share::all},
  };
  for (model::CountConfig& config : all) config.z = z;
  return all;
}

// The worst of all views.
struct Worst {
  double error = 0.0;  // where the stored z allows more than the bar, too
  double rms = 0.0, rms_penumbra = 0.0;
  std::uint64_t mismatched = 0;
  std::uint64_t contributions = 0;
  int views = 0, refused = 0, wide = 0;

  void add(const CountResult& result) {
    error = std::max(error, result.pixels.max_error);
    rms = std::max(rms, result.pixels.rms_error);
    rms_penumbra = std::max(rms_penumbra, result.pixels.rms_penumbra);
    mismatched += result.pixels.mismatched;
    contributions = std::max(contributions, result.counters->contributions_max.value());
  }
};

void expect_words(const traces::Trace& trace, ZChoice z, const model::Datapath& datapath,
                  Worst& worst) {
  model::CountOptions options;
  options.maps = true;
  options.datapath = datapath;
  const auto results = model::count(trace.view(), configs(z), options);
  for (const CountResult& result : results) {
    SCOPED_TRACE(std::string(spelling(result.config.mode)) + " tile " +
                 std::to_string(result.config.tile) + " cull " +
                 std::string(spelling(result.config.cull)) + " z " + std::string(spelling(z)));
    EXPECT_EQ(result.pixels.mismatched, 0U);
    EXPECT_EQ(result.wrong_contributions, 0U);
    EXPECT_LE(result.pixels.rms_error, kMostRms);
    EXPECT_LE(result.pixels.rms_penumbra, kMostRms);
    if (result.counters->li_overflow_pixels.value() == 0) {
      EXPECT_TRUE(result.li == results[0].li) << "words differ";
    }
  }
  worst.add(results[0]);
}

void check_view(const functional::Scene& scene, const Combination& combination, Worst& worst) {
  functional::FrameOptions options;
  options.kind = combination.kind;
  const traces::Trace trace = functional::make_frame(scene, options).trace;
  ++worst.views;
  model::Datapath datapath(model::DatapathKind::fixed);
  const model::CountConfig one;
  const auto most = model::count(trace.view(), {&one, 1})[0].counters->contributions_max.value();
  if (most > kMostOfNarrowLi) {
    datapath.formats.li.fraction_bits = 16;
    datapath.formats.li.integer_bits = 8;
    ++worst.wide;
  }
  expect_words(trace, ZChoice::automatic, datapath, worst);
  if (combination.kind == WedgeKind::WedgeKind_coverage && !trace.header.z_fail_needed) {
    expect_words(trace, ZChoice::fail, datapath, worst);
  }
}

// Round the scene's target, above it, nearer or farther than its own camera.
functional::Camera random_camera(functional::Camera camera, std::mt19937& random) {
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * (static_cast<double>(random()) * 0x1p-32);
  };
  const double distance = glm::length(camera.eye - camera.target) * uniform(0.5, 1.5);
  const double angle = uniform(0.0, 6.283185307179586);
  const double height = uniform(0.1, 0.95);
  const double across = std::sqrt(1.0 - height * height);
  camera.eye = camera.target +
               distance * glm::dvec3(across * std::cos(angle), height, across * std::sin(angle));
  return camera;
}

class FixedDatapath : public testing::TestWithParam<std::string> {};

TEST_P(FixedDatapath, HoldsThePixelBars) {
  const std::string& name = GetParam();
  if (name == "bunny" && !std::filesystem::exists("/usr/share/glmark2/models/bunny.obj")) {
    GTEST_SKIP() << "the package glmark2-data is not installed";
  }
  const int views = random_views();
  std::cout << "seed " << kSeed << ", " << views << " random views\n";
  std::array<Worst, std::size(kCombinations)> worst;
  for (std::size_t i = 0; i < std::size(kCombinations); ++i) {
    if (name == "fire" && kCombinations[i].light == LightShape::sphere) continue;  // textured
    functional::SceneOptions options;
    options.size = {160, 107};
    options.light_shape = kCombinations[i].light;
    std::vector<std::string> notes;
    functional::Scene scene = functional::load_scene(name, options, &notes);
    const functional::Camera own = scene.camera;
    std::mt19937 random(kSeed);
    for (int view = 0; view <= views; ++view) {
      SCOPED_TRACE(name_of(kCombinations[i]) + ", view " + std::to_string(view));
      scene.camera = view == 0 ? own : random_camera(own, random);
      try {
        check_view(scene, kCombinations[i], worst[i]);
      } catch (const InputError&) {  // the eye is within a caster, or the like
        ASSERT_NE(view, 0);
        ++worst[i].refused;
      }
    }
    const Worst& w = worst[i];
    std::cout << name << ' ' << name_of(kCombinations[i]) << ": " << w.views << " views, "
              << w.refused << " refused, " << w.wide << " with wide LI; error at most "
              << w.error * 255.0 << "/255, RMS " << w.rms * 255.0 << "/255, in penumbrae "
              << w.rms_penumbra * 255.0 << "/255, " << w.mismatched << " mismatched, at most "
              << w.contributions << " contributions a pixel\n";
    EXPECT_GE(w.views, 1 + views / 2);
  }
}

std::vector<std::string> scenes() {
  std::vector<std::string> names;
  for (const functional::SceneInfo& info : functional::built_in_scenes()) {
    if (info.name != "mesh") names.push_back(info.name);  // a template, for a user's mesh
  }
  return names;
}

INSTANTIATE_TEST_SUITE_P(BuiltIn, FixedDatapath, testing::ValuesIn(scenes()), [](const auto& test) {
  std::string name = test.param;
  std::replace(name.begin(), name.end(), '-', '_');
  return name;
});

}  // namespace
}  // namespace wedgesim::tests
