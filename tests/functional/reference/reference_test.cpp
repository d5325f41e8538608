#include "functional/reference/reference.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "functional/scene/primitives.h"

namespace wedgesim::functional {
namespace {

constexpr double kEdgeHeight = 2.0;
constexpr double kSlab = 1e-4;  // thickness
constexpr double kLightHeight = 6.0;

// A thin slab that hides all of x > 0 at height 2, a level light over its edge, a floor.
Scene half_plane(LightShape shape) {
  Scene scene;
  scene.width = 80;
  scene.height = 60;
  scene.camera.eye = {-6.0, 1.5, 0.0};
  scene.camera.target = {0.0, 0.0, 0.0};
  scene.camera.far_plane = 60.0;
  scene.light.shape = shape;
  scene.light.centre = {0.1, kLightHeight, 0.2};
  scene.light.half_u = {0.8, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.5};
  scene.light.radius = 0.8;
  Object floor;
  floor.mesh = make_plane({30.0, 30.0}, {1, 1});
  Object slab;
  slab.casts = true;
  slab.mesh = make_box({100.0, kSlab, 400.0});
  for (glm::dvec3& p : slab.mesh.positions) p += glm::dvec3(50.0, kEdgeHeight, 0.0);
  scene.objects = {floor, slab};
  return scene;
}

struct Rendered {
  Window window;
  DepthBuffer depth;
};

Rendered render(const Scene& scene) {
  Rendered r;
  r.window = make_window(scene.camera, scene.width, scene.height);
  r.depth = render_depth(r.window, scene.objects, traces::fb::DepthFormat_float32);
  return r;
}

// The share of the light at x below the shadow's edge, as a point sees it.
double exact(const Scene& scene, const glm::dvec3& p) {
  const Light& light = scene.light;
  if (light.shape == LightShape::rectangle) {
    // The ray to light point X passes the slab's edge at height h at x = p.x + s (X.x − p.x).
    const auto limit = [&](double height) {
      const double s = (height - p.y) / (light.centre.y - p.y);
      return p.x - p.x / s;
    };
    const double least = std::min(limit(kEdgeHeight), limit(kEdgeHeight + kSlab));
    return std::clamp(0.5 + 0.5 * (least - light.centre.x) / light.half_u.x, 0.0, 1.0);
  }
  // The plane through the point and the slab's edge cuts the tangent cone.
  const double distance = glm::distance(p, light.centre);
  const glm::dvec3 axis = (light.centre - p) / distance;
  const glm::dvec3 to_edge = glm::dvec3(0.0, kEdgeHeight, p.z) - p;
  const glm::dvec3 normal = glm::normalize(glm::cross(glm::dvec3(0, 0, 1), to_edge));
  // In the disc of the cone at unit distance: a line at this distance from the middle.
  const double tangent =
      light.radius / std::sqrt(distance * distance - light.radius * light.radius);
  const double along = glm::dot(normal, axis);
  const double off = along / std::sqrt(1.0 - along * along) / tangent;
  if (std::abs(off) >= 1.0) return off > 0.0 ? 1.0 : 0.0;
  return 0.5 + (std::asin(off) + off * std::sqrt(1.0 - off * off)) / std::numbers::pi;
}

struct Error {
  double rms = 0.0;
  double worst = 0.0;
  int penumbra = 0;
};

Error error_of(LightShape shape, int samples, std::uint64_t seed = 1) {
  const Scene scene = half_plane(shape);
  const Rendered r = render(scene);
  const std::vector<float> visibility =
      reference_visibility(scene, r.window, r.depth, samples, seed);
  Error error;
  double sum = 0.0;
  for (std::size_t pixel = 0; pixel < visibility.size(); ++pixel) {
    if (r.depth.triangle[pixel] == DepthBuffer::kSky) continue;
    if (r.depth.surface(pixel).object != 0) continue;
    const auto width = static_cast<std::size_t>(scene.width);
    const glm::dvec3 p = world_point(r.window, static_cast<double>(pixel % width) + 0.5,
                                     static_cast<double>(pixel / width) + 0.5,
                                     traces::decode_depth(r.depth.format, r.depth.words[pixel]));
    const double expected = exact(scene, p);
    const double off = std::abs(static_cast<double>(visibility[pixel]) - expected);
    error.worst = std::max(error.worst, off);
    if (expected <= 0.0 || expected >= 1.0) continue;
    ++error.penumbra;
    sum += off * off;
  }
  error.rms = std::sqrt(sum / std::max(error.penumbra, 1));
  return error;
}

class ReferenceOfLight : public testing::TestWithParam<LightShape> {};

INSTANTIATE_TEST_SUITE_P(Lights, ReferenceOfLight,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

// Does the visibility behind a straight edge follow the exact ramp, and does the error fall as that
// of stratified samples, with the number of samples to the power 3/4?
TEST_P(ReferenceOfLight, StraightEdge) {
  const Error few = error_of(GetParam(), 64);
  const Error many = error_of(GetParam(), 1024);
  std::cout << "RMS error " << few.rms << " with 64 rays, " << many.rms << " with 1024 on "
            << many.penumbra << " pixels\n";
  EXPECT_GT(many.penumbra, 150);
  EXPECT_LT(many.rms, 0.005);
  EXPECT_LT(many.worst, 0.02);
  EXPECT_LT(many.rms, few.rms / 4.0);
  EXPECT_GT(few.rms, 0.005) << "too good to be jittered samples";
}

// Is it the same every time, different by seed, and 1 in the sky?
TEST_P(ReferenceOfLight, Deterministic) {
  Scene scene = half_plane(GetParam());
  scene.camera.target.y = 1.5;  // some sky
  const Rendered r = render(scene);
  const auto once = reference_visibility(scene, r.window, r.depth, 64);
  const auto again = reference_visibility(scene, r.window, r.depth, 64);
  const auto other = reference_visibility(scene, r.window, r.depth, 64, 2);
  EXPECT_EQ(once, again);
  EXPECT_NE(once, other);
  int sky = 0;
  for (std::size_t pixel = 0; pixel < once.size(); ++pixel) {
    ASSERT_GE(once[pixel], 0.0F);
    ASSERT_LE(once[pixel], 1.0F);
    if (r.depth.triangle[pixel] != DepthBuffer::kSky) continue;
    ++sky;
    ASSERT_EQ(once[pixel], 1.0F);
  }
  EXPECT_GT(sky, 100);
}

// One half of a textured light is red, the other green: each is a light of its own.
TEST(Reference, ATextureIsSampledTexelByTexel) {
  Scene scene = half_plane(LightShape::rectangle);
  Image texture(2, 4, 3);
  for (int y = 0; y < 4; ++y) {
    texture.pixel(0, y)[0] = 3.0F;
    texture.pixel(1, y)[1] = 0.5F;
  }
  scene.light.texture = std::make_shared<const Image>(texture);
  const Rendered r = render(scene);
  const auto both = reference_visibility(scene, r.window, r.depth, 1000);
  ASSERT_EQ(both.size(), 3 * r.depth.words.size());
  scene.light.texture.reset();
  const auto even = reference_visibility(scene, r.window, r.depth, 1024);
  Scene half = scene;
  half.light.half_u *= 0.5;
  half.light.centre = scene.light.centre - half.light.half_u;
  const auto red = reference_visibility(half, r.window, r.depth, 1024);
  half.light.centre = scene.light.centre + half.light.half_u;
  const auto green = reference_visibility(half, r.window, r.depth, 1024);
  int soft = 0;
  for (std::size_t i = 0; i < even.size(); ++i) {
    ASSERT_NEAR(both[3 * i], red[i], 0.03F);
    ASSERT_NEAR(both[3 * i + 1], green[i], 0.03F);
    ASSERT_NEAR(both[3 * i + 2], even[i], 0.03F) << "a colour it does not emit is spread evenly";
    soft += red[i] > 0.0F && red[i] < 1.0F ? 1 : 0;
    for (std::size_t c = 0; c < 3; ++c) {
      if (even[i] == 0.0F || even[i] == 1.0F) {
        ASSERT_NEAR(both[3 * i + c], even[i], 0.02F);
      }
    }
  }
  EXPECT_GT(soft, 50);
}

// All of a texture hidden is 0 and none of it hidden is 1, whatever its texels sum to.
TEST(Reference, ATextureIsHiddenAsAWhole) {
  Scene scene = half_plane(LightShape::rectangle);
  Image texture(7, 5, 3);
  for (std::size_t i = 0; i < texture.values.size(); ++i) {
    texture.values[i] = 0.1F + 0.37F * static_cast<float>(i % 11);
  }
  scene.light.texture = std::make_shared<const Image>(texture);
  const Rendered r = render(scene);
  const auto visibility = reference_visibility(scene, r.window, r.depth, 1);
  const auto dark = std::ranges::count(visibility, 0.0F);
  const auto lit = std::ranges::count(visibility, 1.0F);
  EXPECT_GT(dark, 1000);
  EXPECT_GT(lit, 1000);
  for (const float v : visibility) {
    ASSERT_TRUE(v == 0.0F || v == 1.0F || (v > 1e-4F && v < 1.0F - 1e-4F)) << v;
  }
}

// A face sees the part of the light before its plane, up to its very edge.
TEST(Reference, AFaceWhosePlaneCutsTheLight) {
  Scene scene;
  scene.width = 120;
  scene.height = 80;
  scene.camera.eye = {9.0, 3.0, 0.5};
  scene.camera.target = {0.5, 0.5, 0.0};
  scene.camera.field_of_view_degrees = 12.0;
  scene.camera.far_plane = 60.0;
  scene.light.centre = {0.4, 9.0, 0.0};
  scene.light.half_u = {0.8, 0.0, 0.0};
  scene.light.half_v = {0.0, 0.0, 0.8};
  Object box;
  box.casts = true;
  box.mesh = make_box({1.0, 1.0, 1.0});
  scene.objects = {box};
  const Rendered r = render(scene);
  const std::vector<float> seen = reference_visibility(scene, r.window, r.depth, 1024);
  int on_face = 0;
  for (int y = 0; y < scene.height; ++y) {
    for (int x = 0; x < scene.width; ++x) {
      const std::size_t pixel = static_cast<std::size_t>(y) * 120 + static_cast<std::size_t>(x);
      if (r.depth.triangle[pixel] == DepthBuffer::kSky) continue;
      const double z = traces::decode_depth(r.depth.format, r.depth.words[pixel]);
      const glm::dvec3 p = world_point(r.window, x + 0.5, y + 0.5, z);
      if (std::abs(p.x - 0.5) > 1e-4) continue;
      ++on_face;
      EXPECT_NEAR(seen[pixel], 0.7 / 1.6, 0.01) << x << ", " << y;
    }
  }
  EXPECT_GT(on_face, 500);
}

// Numbers of samples that are no squares of multiples of the packet's size.
TEST(Reference, AnyNumberOfSamples) {
  const Scene scene = half_plane(LightShape::rectangle);
  const Rendered r = render(scene);
  const auto three = reference_visibility(scene, r.window, r.depth, 9);
  for (const float v : three) {
    const float ninths = v * 9.0F;
    ASSERT_NEAR(ninths, std::nearbyint(ninths), 1e-5F);
  }
  EXPECT_EQ(reference_visibility(scene, r.window, r.depth, 15), three) << "rounded down to 9";
  for (const float v : reference_visibility(scene, r.window, r.depth, 1)) {
    ASSERT_TRUE(v == 0.0F || v == 1.0F);
  }
}

// A point light is all or nothing.
TEST(Reference, PointLight) {
  Scene scene = half_plane(LightShape::point);
  scene.light.radius = 0.0;
  const Rendered r = render(scene);
  int shadowed = 0;
  for (const float v : reference_visibility(scene, r.window, r.depth, 16)) {
    ASSERT_TRUE(v == 0.0F || v == 1.0F);
    shadowed += v == 0.0F ? 1 : 0;
  }
  EXPECT_GT(shadowed, 100);
}

}  // namespace
}  // namespace wedgesim::functional
