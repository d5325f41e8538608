// How far is each method from ray-traced visibility? Receivers alone: what a caster's own surface
// sees of the light is not what shadow volumes are about.
#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "functional/methods/frame.h"
#include "functional/methods/method.h"
#include "functional/reference/reference.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

constexpr int kRays = 1024;

// The bars of `coverage`.
constexpr double kMostRms = 0.006;
constexpr double kMostPenumbraRms = 0.015;
constexpr int kMostFarOff = 10;  // 20 at 640x427

// Half the pixels of the scenes' own size: the bars are means over some ten thousand pixels.
constexpr std::pair kSize{448, 299};

struct Difference {
  double rms = 0.0;
  double penumbra_rms = 0.0;  // where the reference is neither 0 nor 1
  int far_off = 0;            // pixels off by more than 0.1
  int pixels = 0;
  int penumbra = 0;
};

template <typename Values>
Difference compare(const Scene& scene, const DepthBuffer& depth, const Values& values,
                   const std::vector<float>& reference) {
  Difference difference;
  double sum = 0.0;
  double penumbra_sum = 0.0;
  for (std::size_t pixel = 0; pixel < reference.size(); ++pixel) {
    if (depth.triangle[pixel] == DepthBuffer::kSky) continue;
    if (scene.objects[depth.surface(pixel).object].casts) continue;
    const double truth = static_cast<double>(reference[pixel]);
    const double error = std::clamp(static_cast<double>(values[pixel]), 0.0, 1.0) - truth;
    ++difference.pixels;
    sum += error * error;
    if (std::abs(error) > 0.1) ++difference.far_off;
    if (truth > 0.0 && truth < 1.0) {
      ++difference.penumbra;
      penumbra_sum += error * error;
    }
  }
  difference.rms = std::sqrt(sum / std::max(difference.pixels, 1));
  difference.penumbra_rms = std::sqrt(penumbra_sum / std::max(difference.penumbra, 1));
  return difference;
}

Difference compare(const Scene& scene, const Frame& frame, const std::vector<float>& reference) {
  return compare(scene, frame.depth, frame.trace.expected_li, reference);
}

// The fast method, by its default options.
Difference compare_ssv(const Scene& scene, const Frame& frame,
                       const std::vector<float>& reference) {
  const Visibility ssv =
      render_method({scene, frame.window, frame.depth}, choose_method("test", "ssv"));
  return compare(scene, frame.depth, ssv.values, reference);
}

void expect_close(const Difference& difference) {
  EXPECT_LE(difference.rms, kMostRms);
  EXPECT_LE(difference.penumbra_rms, kMostPenumbraRms);
  EXPECT_LE(difference.far_off, kMostFarOff);
}

void print(const std::string& name, const Difference& difference) {
  std::cout << name << ": RMSE " << difference.rms << " on " << difference.pixels
            << " receiver pixels, " << difference.penumbra_rms << " on " << difference.penumbra
            << " of the penumbra, " << difference.far_off << " off by more than 0.1\n";
}

class Truth : public testing::TestWithParam<std::string> {};

INSTANTIATE_TEST_SUITE_P(Scenes, Truth,
                         testing::Values("plain-columns", "columns", "fractal", "cylinder",
                                         "eye-in-shadow"),
                         [](const auto& parameter) {
                           std::string name = parameter.param;
                           std::replace(name.begin(), name.end(), '-', '_');
                           return name;
                         });

TEST_P(Truth, CoverageIsCloseToRays) {
  SceneOptions options;
  options.size = kSize;
  const Scene scene = load_scene(GetParam(), options);
  const Frame frame = make_frame(scene);
  const std::vector<float> reference =
      reference_visibility(scene, frame.window, frame.depth, kRays);
  const Difference coverage = compare(scene, frame, reference);
  print(GetParam() + " coverage", coverage);
  EXPECT_GT(coverage.penumbra, 2000);
  expect_close(coverage);
  const Difference ssv = compare_ssv(scene, frame, reference);
  print(GetParam() + " ssv", ssv);
  expect_close(ssv);

  FrameOptions linear;
  linear.kind = traces::fb::WedgeKind_linear;
  print(GetParam() + " linear", compare(scene, make_frame(scene, linear), reference));
}

// A sphere of the same size, from one of the views.
TEST(TruthOfSpheres, CoverageIsCloseToRays) {
  SceneOptions options;
  options.size = kSize;
  options.light_shape = LightShape::sphere;
  const Scene scene = load_scene("plain-columns", options);
  const Frame frame = make_frame(scene);
  const std::vector<float> reference =
      reference_visibility(scene, frame.window, frame.depth, kRays);
  const Difference coverage = compare(scene, frame, reference);
  print("plain-columns, sphere, coverage", coverage);
  expect_close(coverage);
  const Difference ssv = compare_ssv(scene, frame, reference);
  print("plain-columns, sphere, ssv", ssv);
  expect_close(ssv);
}

}  // namespace
}  // namespace wedgesim::functional
