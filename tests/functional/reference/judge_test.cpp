#include "functional/reference/judge.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "base/error.h"
#include "functional/methods/light_intensity.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

constexpr double kTolerance = 1e-6;

std::vector<std::size_t> surfaces_of(const Frame& frame) {
  std::vector<std::size_t> pixels;
  for (std::size_t i = 0; i < frame.depth.triangle.size(); ++i) {
    if (frame.depth.triangle[i] != DepthBuffer::kSky) pixels.push_back(i);
  }
  return pixels;
}

struct View {
  const char* scene;
  LightShape light;
  fb::WedgeKind kind = fb::WedgeKind_coverage;
  fb::DepthFormat depth = fb::DepthFormat_unorm24;
};

Scene scene_of(const View& view, std::pair<int, int> size = {160, 107}) {
  SceneOptions options;
  options.size = size;
  options.light_shape = view.light;
  return load_scene(view.scene, options);
}

Frame frame_of(const Scene& scene, const View& view) {
  FrameOptions options;
  options.kind = view.kind;
  options.depth_format = view.depth;
  return make_frame(scene, options);
}

struct Comparison {
  std::size_t pixels = 0;
  std::size_t off = 0;   // by more than the tolerance and the trace's sensitivity
  double largest = 0.0;  // difference where the sensitivity is below the tolerance
};

Comparison compare(const Scene& scene, const Frame& frame, const std::vector<double>& li) {
  const std::vector<std::size_t> pixels = surfaces_of(frame);
  const std::vector<double> judged = judge_light_intensity(scene, frame, pixels);
  Comparison result;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    const double difference = std::abs(li[pixels[i]] - judged[i]);
    const double sensitivity = frame.trace.li_sensitivity[pixels[i]];
    if (sensitivity < kTolerance) result.largest = std::max(result.largest, difference);
    ++result.pixels;
    if (!(difference <= kTolerance + sensitivity)) ++result.off;
  }
  return result;
}

// Does the renderer give every surface of ordinary scenes what the judge gives it?
TEST(Judge, AgreesWithTheRendererOnScenes) {
  const auto rectangle = LightShape::rectangle;
  const auto linear = fb::WedgeKind_linear;
  const View views[] = {
      {"plain-columns", rectangle},
      {"cylinder", rectangle},
      {"cylinder", LightShape::sphere},
      {"cylinder", LightShape::point},
      {"eye-in-shadow", rectangle},
      {"eye-in-shadow", LightShape::sphere},
      {"ground-polygon", rectangle},
      {"cylinder", rectangle, linear},
      {"cylinder", LightShape::sphere, linear},
      {"eye-in-shadow", rectangle, linear},
      {"overlap", rectangle, fb::WedgeKind_coverage, fb::DepthFormat_float32_reversed},
      {"overlap", LightShape::sphere, fb::WedgeKind_coverage, fb::DepthFormat_unorm16},
  };
  for (const View& view : views) {
    const Scene scene = scene_of(view);
    const Frame frame = frame_of(scene, view);
    const auto start = std::chrono::steady_clock::now();
    const Comparison result = compare(scene, frame, frame.trace.expected_li);
    const std::chrono::duration<double> seconds = std::chrono::steady_clock::now() - start;
    std::cout << view.scene << ' ' << static_cast<int>(view.light) << ' '
              << static_cast<int>(view.kind) << ": " << result.pixels << " pixels, "
              << frame.trace.wedges.size() << " wedges, largest " << result.largest << ", off "
              << result.off << ", " << seconds.count() << " s, "
              << static_cast<double>(result.pixels * frame.trace.wedges.size()) / seconds.count()
              << " pairs/s\n";
    EXPECT_GT(result.pixels, 1000U);
    EXPECT_EQ(result.off, 0U) << view.scene;
  }
}

// Does the judge see a plane that is off, a wedge that is too tight, a wrong sign?
TEST(Judge, SeesPlantedErrors) {
  for (const View view : {View{"cylinder", LightShape::rectangle},
                          View{"cylinder", LightShape::rectangle, fb::WedgeKind_linear}}) {
    const Scene scene = scene_of(view);
    const Frame frame = frame_of(scene, view);
    const auto off_with = [&](const auto& change) {
      ShadowGeometry changed = frame.geometry;
      change(changed);
      const LightIntensity light =
          evaluate_light_intensity(scene, frame.window, frame.depth, changed, frame.trace,
                                   frame.trace.header.expected_z_method);
      return compare(scene, frame, light.li).off;
    };
    EXPECT_EQ(off_with([](const ShadowGeometry&) {}), 0U);
    EXPECT_GT(off_with([](ShadowGeometry& g) {
                for (SidedPlane& plane : g.umbra_planes) plane.plane.w += 0.01;
              }),
              0U);
    EXPECT_GT(off_with([](ShadowGeometry& g) {
                for (SidedPlane& plane : g.umbra_planes) plane.minus = !plane.minus;
              }),
              100U);
    EXPECT_GT(off_with([](ShadowGeometry& g) {
                for (ShadowWedge& wedge : g.wedges) {
                  wedge.planes[0].plane.w += wedge.planes[0].minus ? 0.05 : -0.05;
                }
              }),
              0U);
  }
}

}  // namespace
}  // namespace wedgesim::functional
