#include "functional/methods/frame.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/error.h"
#include "functional/methods/brute_force.h"
#include "functional/scene/scene_file.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

Scene small(const std::string& name) {
  SceneOptions options;
  options.size = {80, 53};
  return load_scene(name, options);
}

// Does the trace say all that the renderer knows of frame, camera and light?
TEST(Frame, HeaderDescribesTheScene) {
  const Scene scene = small("plain-columns");
  const Frame frame = make_frame(scene);
  const traces::Header& header = frame.trace.header;
  EXPECT_EQ(header.name, scene.name);
  EXPECT_EQ(header.width, 80U);
  EXPECT_EQ(header.height, 53U);
  EXPECT_EQ(header.depth_format, fb::DepthFormat_unorm24);
  EXPECT_EQ(header.camera.eye.x(), scene.camera.eye.x);
  ASSERT_EQ(header.lights.size(), 1U);
  EXPECT_EQ(header.lights[0].shape, fb::LightShape_rectangle);
  EXPECT_EQ(header.casters.size(), 8U);
  EXPECT_EQ(frame.trace.depth, frame.depth.words);
  // Light space from window space: a corner of the light, seen through both matrices.
  const glm::dvec3 corner = scene.light.centre + scene.light.half_u - scene.light.half_v;
  const glm::dvec4 h = frame.window.window_from_world * glm::dvec4(corner, 1.0);
  const auto& m = *header.lights[0].light_from_window.columns();
  const auto row = [&](std::uint16_t r) {
    const auto at = [&](std::uint16_t c) { return m[static_cast<std::uint16_t>(4 * c + r)]; };
    return (at(0) * h.x + at(1) * h.y + at(2) * h.z + at(3) * h.w);
  };
  EXPECT_NEAR(row(0) / row(3), 1.0, 1e-9);
  EXPECT_NEAR(row(1) / row(3), -1.0, 1e-9);
  EXPECT_NEAR(row(2) / row(3), 0.0, 1e-9);
}

// A scene far from the world's origin loses nothing but what its own coordinates have lost; moved
// by whole powers of two it has lost nothing.
TEST(Frame, DoesNotDependOnWhereTheSceneIs) {
  Scene scene = small("plain-columns");
  const auto snapped = [](double x) { return std::ldexp(std::nearbyint(std::ldexp(x, 20)), -20); };
  for (Object& object : scene.objects) {
    for (glm::dvec3& p : object.mesh.positions) p = {snapped(p.x), snapped(p.y), snapped(p.z)};
  }
  const auto moved = [&](const glm::dvec3& offset) {
    Scene far = scene;
    for (Object& object : far.objects) {
      for (glm::dvec3& p : object.mesh.positions) p += offset;
    }
    far.camera.eye += offset;
    far.camera.target += offset;
    far.light.centre += offset;
    return make_frame(far).trace;
  };
  const traces::Trace here = make_frame(scene).trace;
  const traces::Trace there = moved({16777216.0, 0.0, -4194304.0});
  ASSERT_EQ(there.expected_li.size(), here.expected_li.size());
  EXPECT_EQ(there.depth, here.depth);
  EXPECT_EQ(there.wedges.size(), here.wedges.size());
  for (std::size_t i = 0; i < here.expected_li.size(); ++i) {
    ASSERT_NEAR(there.expected_li[i], here.expected_li[i], 1e-9 + here.li_sensitivity[i]) << i;
  }
  EXPECT_EQ(there.header.lights[0].centre.x(), here.header.lights[0].centre.x() + 16777216.0);
}

TEST(Frame, ExpectedLightIsOptional) {
  FrameOptions options;
  options.expected_li = false;
  const Frame without = make_frame(small("plain-columns"), options);
  EXPECT_TRUE(without.trace.expected_li.empty());
  EXPECT_TRUE(without.trace.li_sensitivity.empty());
  const Frame with = make_frame(small("plain-columns"));
  EXPECT_EQ(with.trace.expected_li.size(), 80U * 53U);
  EXPECT_EQ(with.trace.li_sensitivity.size(), 80U * 53U);
  EXPECT_EQ(with.trace.wedges.size(), without.trace.wedges.size());
}

// Is a light without area a point light, with hard shadows as the brute force has them?
TEST(Frame, LightsWithoutExtentCastHardShadows) {
  Scene scene = small("cylinder");
  scene.light.half_u = glm::dvec3(0.0);
  EXPECT_THROW(make_frame(scene), InputError);
  scene.light.shape = LightShape::point;
  const Frame frame = make_frame(scene);
  EXPECT_TRUE(frame.trace.wedges.empty());
  std::vector<std::size_t> pixels(frame.depth.words.size());
  std::iota(pixels.begin(), pixels.end(), std::size_t{0});
  const std::vector<double> truth =
      brute_force_light_intensity(scene, frame.window, frame.depth, frame.geometry, pixels);
  std::size_t differing = 0;
  std::size_t dark = 0;
  for (const std::size_t i : pixels) {
    if (frame.depth.triangle[i] == DepthBuffer::kSky) continue;
    differing += truth[i] != frame.trace.expected_li[i] ? 1 : 0;
    dark += frame.trace.expected_li[i] == 0.0 ? 1 : 0;
  }
  EXPECT_LE(differing, 8U);
  EXPECT_GT(dark, 100U);
}

// Is a fixed length that a ray never reaches refused, and one it reaches kept?
TEST(Frame, FixedLength) {
  const Scene scene = small("cylinder");
  FrameOptions options;
  options.length = 3.0;
  EXPECT_FALSE(make_frame(scene, options).trace.wedges.empty());
  Scene beside = scene;
  beside.light.centre = scene.objects[1].mesh.positions[0] + glm::dvec3(-0.8, 0.3, 0.0);
  beside.light.shape = LightShape::sphere;
  beside.light.radius = 0.7;
  EXPECT_THROW(make_frame(beside, options), InputError);
}

// z-pass by itself where it is right, z-fail where the eye is in shadow, where z-pass is refused.
TEST(Frame, ZMethods) {
  EXPECT_EQ(make_frame(small("plain-columns")).trace.header.expected_z_method, fb::ZMethod_pass);
  const Scene in_shadow = small("eye-in-shadow");
  EXPECT_EQ(make_frame(in_shadow).trace.header.expected_z_method, fb::ZMethod_fail);
  FrameOptions options;
  options.z_method = fb::ZMethod_pass;
  EXPECT_THROW(make_frame(in_shadow, options), InputError);
  options.z_method = fb::ZMethod_fail;
  EXPECT_EQ(make_frame(small("plain-columns"), options).trace.header.expected_z_method,
            fb::ZMethod_fail);
}

// How far does a coarser depth change the light? By no more than it says, nearly everywhere.
TEST(Frame, DepthFormatsAgreeWithinSensitivity) {
  const Scene scene = small("plain-columns");
  const Frame base = make_frame(scene);
  for (const fb::DepthFormat format :
       {fb::DepthFormat_float32, fb::DepthFormat_float32_reversed, fb::DepthFormat_unorm16}) {
    FrameOptions options;
    options.depth_format = format;
    const Frame frame = make_frame(scene, options);
    int off = 0;
    for (std::size_t i = 0; i < base.trace.expected_li.size(); ++i) {
      const double allowed = 1e-4 + 2.0 * static_cast<double>(base.trace.li_sensitivity[i] +
                                                              frame.trace.li_sensitivity[i]);
      if (std::abs(frame.trace.expected_li[i] - base.trace.expected_li[i]) > allowed) ++off;
    }
    EXPECT_LE(off, format == fb::DepthFormat_unorm16 ? 40 : 2) << fb::EnumNameDepthFormat(format);
  }
}

// The same bits every time.
TEST(Frame, IsDeterministic) {
  const Scene scene = small("columns");
  const Frame one = make_frame(scene);
  const Frame two = make_frame(scene);
  EXPECT_EQ(one.trace.expected_li, two.trace.expected_li);
  EXPECT_EQ(one.trace.li_sensitivity, two.trace.li_sensitivity);
  EXPECT_EQ(one.trace.depth, two.trace.depth);
  EXPECT_EQ(one.trace.indices, two.trace.indices);
}

}  // namespace
}  // namespace wedgesim::functional
