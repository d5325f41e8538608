#include "functional/raster/depth_buffer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <limits>
#include <optional>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

class DepthBufferFormats : public testing::TestWithParam<fb::DepthFormat> {};

INSTANTIATE_TEST_SUITE_P(Formats, DepthBufferFormats,
                         testing::Values(fb::DepthFormat_unorm24, fb::DepthFormat_float32,
                                         fb::DepthFormat_unorm16, fb::DepthFormat_float32_reversed),
                         [](const auto& parameter) {
                           return std::string(fb::EnumNameDepthFormat(parameter.param));
                         });

constexpr int kWidth = 64;
constexpr int kHeight = 48;

Window plain_window() {
  Camera camera;
  camera.eye = {0.0, 0.0, 0.0};
  camera.target = {0.0, 0.0, -1.0};
  camera.field_of_view_degrees = 60.0;
  camera.near_plane = 0.5;
  camera.far_plane = 20.0;
  return make_window(camera, kWidth, kHeight);
}

// What a ray from the eye hits, with how far inside the triangle (in barycentric coordinates, 0 on
// an edge, negative outside): by areas in the triangle's plane.
struct Hit {
  glm::dvec3 point;
  double margin;
};

std::optional<Hit> hit(const glm::dvec3& eye, const glm::dvec3& way, const glm::dvec3& a,
                       const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 n = glm::cross(b - a, c - a);
  const double slope = glm::dot(n, way);
  if (std::abs(slope) < 1e-9) return std::nullopt;
  const double t = glm::dot(n, a - eye) / slope;
  if (t <= 0.0) return std::nullopt;
  const glm::dvec3 p = eye + t * way;
  const double nn = glm::dot(n, n);
  const double u = glm::dot(n, glm::cross(b - a, p - a)) / nn;
  const double v = glm::dot(n, glm::cross(c - b, p - b)) / nn;
  const double w = glm::dot(n, glm::cross(a - c, p - c)) / nn;
  return Hit{p, std::min({u, v, w})};
}

// Half a step of a format at a depth.
double rounding(fb::DepthFormat format, double z) {
  switch (format) {
    case fb::DepthFormat_unorm24:
      return 0.5 / 16777215.0;
    case fb::DepthFormat_unorm16:
      return 0.5 / 65535.0;
    case fb::DepthFormat_float32:
      return z * 0x1p-24;
    case fb::DepthFormat_float32_reversed:
      return (1.0 - z) * 0x1p-24;
  }
  return 0.0;
}

// Is the depth of a pixel that of the nearest surface on the ray through its centre, some of the
// triangles crossing the near plane?
TEST_P(DepthBufferFormats, DepthIsThatOfTheRayThroughThePixelCentre) {
  Random random(41);
  const Window window = plain_window();
  Object object;
  for (std::uint32_t i = 0; i < 80; ++i) {
    const glm::dvec3 middle =
        random.in_box(glm::dvec3(-6.0, -4.0, -15.0), glm::dvec3(6.0, 4.0, -0.5));
    for (int k = 0; k < 3; ++k) {
      object.mesh.positions.push_back(middle + random.uniform(0.5, 4.0) * random.direction());
    }
    object.mesh.triangles.push_back({3 * i, 3 * i + 1, 3 * i + 2});
  }
  const std::vector<Object> objects{object};
  const DepthBuffer buffer = render_depth(window, objects, GetParam());
  ASSERT_EQ(buffer.words.size(), static_cast<std::size_t>(kWidth * kHeight));
  int compared = 0;
  int sky = 0;
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto pixel = static_cast<std::size_t>(y * kWidth + x);
      const glm::dvec3 way = world_point(window, x + 0.5, y + 0.5, 0.5) - window.eye;
      double nearest = 1.0;
      std::uint32_t seen = DepthBuffer::kSky;
      bool doubtful = false;  // near an edge, where snapping decides
      for (std::uint32_t t = 0; t < object.mesh.triangles.size(); ++t) {
        const glm::dvec3* p = &object.mesh.positions[std::size_t{3} * t];
        const auto found = hit(window.eye, way, p[0], p[1], p[2]);
        if (!found || found->margin < -0.02) continue;
        const glm::dvec4 h = window.window_from_world * glm::dvec4(found->point, 1.0);
        const double z = h.z / h.w;
        if (z < -1e-3) continue;  // in front of the near plane
        if (found->margin < 0.02 || z < 1e-3) doubtful = true;
        if (z < nearest) {
          nearest = z;
          seen = t;
        }
      }
      if (doubtful) continue;
      ++compared;
      if (seen == DepthBuffer::kSky) ++sky;
      const double stored = traces::decode_depth(buffer.format, buffer.words[pixel]);
      ASSERT_NEAR(stored, nearest, rounding(GetParam(), nearest) + 1e-12) << x << ' ' << y;
      if (GetParam() != fb::DepthFormat_unorm16) {
        ASSERT_EQ(buffer.triangle[pixel], seen) << x << ' ' << y;
      }
    }
  }
  EXPECT_GT(compared - sky, kWidth * kHeight / 3);
}

// Triangles whose tip the near plane cuts off by next to nothing snap into outlines that are not
// convex: do they still cover what they should?
TEST(DepthBuffer, TipsCutByTheNearPlane) {
  Random random(42);
  const Window window = plain_window();
  const glm::dvec3 forward(0.0, 0.0, -1.0);
  for (int i = 0; i < 3000; ++i) {
    // A tip on the near plane in the frame, behind it by less than a hundredth of a pixel.
    const glm::dvec3 tip =
        world_point(window, random.uniform(0.0, kWidth), random.uniform(0.0, kHeight), 0.0) -
        std::pow(10.0, random.uniform(-7.0, -3.0)) * forward;
    Object object;
    for (int k = 0; k < 2; ++k) {
      object.mesh.positions.push_back(random.in_box({-4.0, -4.0, -6.0}, {4.0, 4.0, -0.6}));
    }
    object.mesh.positions.push_back(tip);
    const auto& p = object.mesh.positions;
    const glm::dvec3 normal = glm::normalize(glm::cross(p[1] - p[0], p[2] - p[0]));
    if (std::abs(glm::dot(normal, tip)) < 0.02) continue;  // a sliver on the screen
    object.mesh.triangles = {{0, 1, 2}};
    const std::vector<Object> objects{object};
    const DepthBuffer buffer = render_depth(window, objects, fb::DepthFormat_float32);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const glm::dvec3 way = world_point(window, x + 0.5, y + 0.5, 0.5) - window.eye;
        const auto found = hit(window.eye, way, p[0], p[1], p[2]);
        if (!found || std::abs(found->margin) < 0.03 || -found->point.z < 0.501) continue;
        ASSERT_EQ(buffer.triangle[static_cast<std::size_t>(y * kWidth + x)] == 0U,
                  found->margin > 0.0)
            << "case " << i << ", pixel " << x << ' ' << y;
      }
    }
  }
}

// Does the first of coinciding triangles keep the pixel, within an object and across objects?
TEST_P(DepthBufferFormats, FirstTriangleWinsTies) {
  const Window window = plain_window();
  Object object;
  object.mesh.positions = {{-9, -9, -5}, {9, -9, -5}, {0, 9, -5},
                           {-9, -9, -6}, {9, -9, -6}, {0, 9, -6}};
  object.mesh.triangles = {{3, 4, 5}, {0, 1, 2}, {0, 1, 2}};
  const std::vector<Object> objects{object, object};
  const DepthBuffer buffer = render_depth(window, objects, GetParam());
  const std::size_t middle = kHeight / 2 * kWidth + kWidth / 2;
  EXPECT_EQ(buffer.triangle[middle], 1U);
  const DepthBuffer::Surface surface = buffer.surface(middle);
  EXPECT_EQ(surface.object, 0U);
  EXPECT_EQ(surface.triangle, 1U);
}

TEST_P(DepthBufferFormats, EmptyPixelsAreSky) {
  const Window window = plain_window();
  const DepthBuffer buffer = render_depth(window, {}, GetParam());
  for (std::size_t i = 0; i < buffer.words.size(); ++i) {
    ASSERT_EQ(buffer.words[i], traces::sky_word(GetParam()));
    ASSERT_EQ(traces::decode_depth(GetParam(), buffer.words[i]), 1.0);
    ASSERT_EQ(buffer.triangle[i], DepthBuffer::kSky);
  }
}

// Which object and triangle does a scene's triangle belong to, also after objects of none?
TEST(DepthBuffer, SurfaceNamesObjectAndTriangle) {
  const Window window = plain_window();
  Object empty;
  Object left;
  left.mesh.positions = {{-9, -9, -5}, {0, -9, -5}, {0, 9, -5}, {-9, 9, -5}};
  left.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  Object right;
  right.mesh.positions = {{0, -9, -5}, {9, -9, -5}, {9, 9, -5}, {0, 9, -5}};
  right.mesh.triangles = {{0, 1, 2}, {0, 2, 3}};
  const std::vector<Object> objects{empty, left, empty, right};
  const DepthBuffer buffer = render_depth(window, objects, fb::DepthFormat_unorm24);
  EXPECT_EQ(buffer.first_triangle, (std::vector<std::uint32_t>{0, 0, 2, 2, 4}));
  for (int y = 0; y < kHeight; ++y) {
    for (int x = 0; x < kWidth; ++x) {
      const auto surface = buffer.surface(static_cast<std::size_t>(y * kWidth + x));
      ASSERT_EQ(surface.object, x < kWidth / 2 ? 1U : 3U) << x << ' ' << y;
      ASSERT_LT(surface.triangle, 2U);
    }
  }
}

}  // namespace
}  // namespace wedgesim::functional
