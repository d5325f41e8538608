#include "functional/reference/judge.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cmath>
#include <iostream>

#include "functional/methods/light_intensity.h"
#include "functional/scene/origin.h"
#include "functional/scene/primitives.h"
#include "functional/scene/scene_file.h"

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

// Pixels that a change of a frame's geometry puts off, with a judge who is given the same frame.
template <typename Change>
std::size_t off_with(const Scene& scene, const Frame& frame, const Change& change) {
  Frame changed = frame;
  change(changed.geometry);
  changed.trace.expected_li =
      evaluate_light_intensity(scene, frame.window, frame.depth, changed.geometry, frame.trace,
                               frame.trace.header.expected_z_method)
          .li;
  return compare(scene, changed, changed.trace.expected_li).off;
}

// Does the judge see a plane that is off, a wedge that is too tight, a wrong sign?
TEST(Judge, SeesPlantedErrors) {
  for (const View view : {View{"cylinder", LightShape::rectangle},
                          View{"cylinder", LightShape::rectangle, fb::WedgeKind_linear},
                          View{"cylinder", LightShape::sphere, fb::WedgeKind_linear}}) {
    const Scene scene = scene_of(view);
    const Frame frame = frame_of(scene, view);
    const auto off_with = [&](const auto& change) {
      return functional::off_with(scene, frame, change);
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
    EXPECT_GT(off_with([](ShadowGeometry& g) {
                for (ShadowWedge& wedge : g.wedges) {
                  SidedPlane& end =
                      wedge.planes[g.kind == fb::WedgeKind_linear ? kLinearPlanes - 1
                                                                  : wedge.planes.size() - 1];
                  end.plane.w += end.minus ? 1.0 : -1.0;
                }
              }),
              0U)
        << "volumes that end before the floor";
  }
}

// Are planes and factors of linear wedges not taken on trust?
TEST(Judge, SeesWrongPlanesAndFactorsOfLinearWedges) {
  for (const LightShape light : {LightShape::rectangle, LightShape::sphere}) {
    const View view{"overlap", light, fb::WedgeKind_linear};
    const Scene scene = scene_of(view, {80, 53});
    const Frame frame = frame_of(scene, view);
    ASSERT_EQ(off_with(scene, frame, [](const ShadowGeometry&) {}), 0U);
    for (std::size_t plane = 0; plane < 4; ++plane) {
      EXPECT_GT(off_with(scene, frame,
                         [&](ShadowGeometry& g) {
                           for (ShadowWedge& wedge : g.wedges) {
                             wedge.planes[plane].plane.w += 0.01;
                           }
                         }),
                10U)
          << "plane " << plane;
    }
    for (std::size_t factor = 0; factor < 6; ++factor) {
      EXPECT_GT(off_with(scene, frame,
                         [&](ShadowGeometry& g) {
                           for (ShadowWedge& wedge : g.wedges) wedge.factors[factor] *= 1.05;
                         }),
                10U)
          << "factor " << factor;
    }
  }
}

// Does the judge miss that volumes end before a receiver does, where the umbra polygons that close
// them are in a wrong plane?
TEST(Judge, SeesWrongEnds) {
  const View view{"eye-in-shadow", LightShape::rectangle};
  const Scene scene = scene_of(view);
  const Frame frame = frame_of(scene, view);
  ASSERT_EQ(frame.trace.header.expected_z_method, fb::ZMethod_fail);
  EXPECT_GT(off_with(scene, frame,
                     [&](ShadowGeometry& g) {
                       for (std::size_t i = 0; i < g.umbra_planes.size(); ++i) {
                         if (g.umbra_sources[i].plane != UmbraPlane::end) continue;
                         SidedPlane& end = g.umbra_planes[i];
                         end.plane.w += end.minus ? 3.0 : -3.0;
                       }
                     }),
            0U);
}

// Is a scene far from the world's origin judged by what it is, not by where it is?
TEST(Judge, KnowsTheFramesOrigin) {
  for (const fb::WedgeKind kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
    const View view{"cylinder", LightShape::rectangle, kind};
    const glm::dvec3 offset(1e5, -3e5, 2e5);
    const Scene scene = taken_from(scene_of(view), offset);
    const Frame frame = frame_of(scene, view);
    ASSERT_NE(frame.origin, glm::dvec3(0.0));
    const Comparison result = compare(scene, frame, frame.trace.expected_li);
    std::cout << "largest difference " << result.largest << '\n';
    EXPECT_GT(result.pixels, 1000U);
    EXPECT_EQ(result.off, 0U);
  }
}

// Does an edge without a wedge count for the judge as one with it?
TEST(Judge, MissesALostWedge) {
  const View view{"cylinder", LightShape::rectangle};
  const Scene scene = scene_of(view);
  Frame frame = frame_of(scene, view);
  EXPECT_TRUE(frame.geometry.bare_edges.empty());
  const std::vector<std::size_t> pixels = surfaces_of(frame);
  const std::vector<double> before = judge_light_intensity(scene, frame, pixels);
  const ShadowWedge& lost = frame.geometry.wedges.back();
  frame.geometry.bare_edges.push_back(
      {lost.source, lost.umbra_plane, lost.planes, frame.trace.wedges.back().umbra()});
  frame.geometry.wedges.pop_back();
  frame.trace.wedges.pop_back();
  EXPECT_EQ(judge_light_intensity(scene, frame, pixels), before);
  frame.geometry.bare_edges.clear();
  EXPECT_NE(judge_light_intensity(scene, frame, pixels), before);
}

// Is the sensitivity that of the trace, where both are more than rounding?
TEST(Judge, SensitivityIsTheTraces) {
  const View view{"cylinder", LightShape::sphere, fb::WedgeKind_coverage, fb::DepthFormat_unorm16};
  const Scene scene = scene_of(view);
  const Frame frame = frame_of(scene, view);
  const std::vector<std::size_t> pixels = surfaces_of(frame);
  const std::vector<double> judged = judge_with_sensitivity(scene, frame, pixels).sensitivity;
  int sensitive = 0;
  for (std::size_t i = 0; i < pixels.size(); ++i) {
    ASSERT_NEAR(judged[i], frame.trace.li_sensitivity[pixels[i]], 1e-7) << pixels[i];
    if (judged[i] > 1e-4) ++sensitive;
  }
  EXPECT_GT(sensitive, 100);
}

Object object_of(Mesh mesh, const glm::dvec3& shift, bool casts) {
  for (glm::dvec3& p : mesh.positions) p += shift;
  return {std::move(mesh), casts};
}

// A ball over a floor, some of its vertices in one place, and a box with an edge that points at the
// light's centre but for 1e-9.
Scene degenerate_scene(LightShape light) {
  Scene scene;
  scene.width = 32;
  scene.height = 24;
  scene.camera = {{0.0, 2.5, 4.0}, {0.0, 0.5, 0.0}};
  scene.light.shape = light;
  scene.light.centre = {0.5 + 1e-9, 3.0, 0.5 - 1e-9};
  scene.light.half_u = {0.3, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.3};
  scene.light.radius = 0.3;
  Mesh ball = make_sphere(0.4, 8, 6);
  for (const std::size_t triangle : {3U, 20U, 41U}) {
    const auto& corners = ball.triangles[triangle];
    ball.positions[corners[0]] = ball.positions[corners[1]];
  }
  scene.objects = {object_of(make_plane({6.0, 6.0}, {1, 1}), {}, false),
                   object_of(ball, {-0.8, 1.0, 0.0}, true),
                   object_of(make_box({1.0, 1.0, 1.0}), {}, true)};
  return scene;
}

// A box beside the plane x = 0, in which the eye, the light's centre and the middle column of
// pixels lie: does the judge put points on the shadow quad where the trace's rule puts them?
TEST(Judge, TiesGoAsInTheTrace) {
  for (const LightShape light : {LightShape::rectangle, LightShape::sphere}) {
    for (const double side : {0.5, -0.5}) {
      Scene scene = degenerate_scene(light);
      scene.width = 33;
      scene.light.centre = {0.0, 3.0, 0.0};
      scene.objects = {object_of(make_plane({6.0, 6.0}, {1, 1}), {}, false),
                       object_of(make_box({1.0, 0.5, 1.0}), {side, 0.5, 0.0}, true)};
      const Frame frame = frame_of(scene, {"", light});
      std::vector<std::size_t> column;
      for (const std::size_t pixel : surfaces_of(frame)) {
        if (pixel % 33 == 16) column.push_back(pixel);
      }
      const std::vector<double> judged = judge_light_intensity(scene, frame, column);
      int half = 0;
      for (std::size_t i = 0; i < column.size(); ++i) {
        EXPECT_NEAR(frame.trace.expected_li[column[i]], judged[i], kTolerance) << column[i];
        if (std::abs(std::abs(judged[i] - 1.0) - 0.5) < 1e-9) ++half;
      }
      EXPECT_GT(half, 2);
    }
  }
}

// Edges of no length, edges at the light, the eye at the light: does every pixel get a number?
TEST(Judge, GivesNumbersForDegenerateInput) {
  for (const LightShape light : {LightShape::rectangle, LightShape::sphere, LightShape::point}) {
    for (const fb::WedgeKind kind : {fb::WedgeKind_coverage, fb::WedgeKind_linear}) {
      for (const bool eye_at_light : {false, true}) {
        Scene scene = degenerate_scene(light);
        if (eye_at_light) scene.camera.eye = scene.light.centre;
        const Frame frame = frame_of(scene, {"", light, kind});
        const std::vector<std::size_t> pixels = surfaces_of(frame);
        ASSERT_GT(pixels.size(), 300U);
        int shadowed = 0, in_part = 0;
        for (const int step : {-1, 0, 1}) {
          for (const double li : judge_light_intensity(scene, frame, pixels, step)) {
            ASSERT_TRUE(std::abs(li) <= 2.0) << li;
            if (li < 0.5) ++shadowed;
            if (li > 0.5 && li < 0.99) ++in_part;
          }
        }
        EXPECT_EQ(in_part > 50, light != LightShape::point) << in_part;
        if (!eye_at_light) {
          EXPECT_GT(shadowed, 50);
        } else if (kind == fb::WedgeKind_coverage || light == LightShape::point) {
          EXPECT_EQ(shadowed, 0) << "where the light's centre is seen";
        } else {
          EXPECT_LT(shadowed, 50) << "half a penumbra is brighter, but for rough wedges";
        }
      }
    }
  }
}

}  // namespace
}  // namespace wedgesim::functional
