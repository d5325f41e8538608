#include "functional/methods/plane_canvas.h"

#include <gtest/gtest.h>

#include <cmath>

#include "functional/geometry/plane_shadow.h"
#include "functional/geometry/ring_strips.h"
#include "functional/scene/primitives.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr int kSize = 64;  // pixels each way
constexpr int kStep = 4;   // steps of the grid from pixel to pixel

// A floor seen from straight above, so that pixel centres are points of the plane's grid: a step of
// the grid is a quarter of a pixel.
struct PlaneCanvas : testing::Test {
  static Scene make_scene() {
    Scene scene;
    scene.light.centre = {0, 10, 0};
    scene.camera = {{0, 8, 0}, {0, 0, 0}, {0, 0, -1}, 0, 0.5, 20};
    scene.camera.field_of_view_degrees = 2.0 * std::atan(0.5) * 180.0 / M_PI;
    scene.objects.push_back({make_plane({20, 20}, {1, 1}), false, {}});
    return scene;
  }
  PlaneCanvas() { plane.unit = 8.0 / (kSize * kStep); }

  Visibility draw(const std::vector<PlaneCell>& cells) const {
    Visibility result;
    result.values.assign(depth.words.size(), 1.0F);
    draw_on_plane({scene, window, depth}, plane, cells, result);
    return result;
  }

  Scene scene = make_scene();
  Window window = make_window(scene.camera, kSize, kSize);
  DepthBuffer depth = render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  ReceiverPlane plane = find_receiver_plane(scene);
};

// The grid coordinate of a pixel's centre.
std::int32_t centre(int pixels) { return kStep * pixels + kStep / 2; }

std::vector<GridSegment> loop(const std::vector<GridPoint>& points) {
  std::vector<GridSegment> segments;
  for (std::size_t i = 0; i < points.size(); ++i) {
    segments.push_back({points[i], points[(i + 1) % points.size()], 1});
  }
  return segments;
}

std::vector<PlaneCell> cells_of(const std::vector<std::vector<GridSegment>>& outlines) {
  const Rings rings = merge_silhouettes(outlines);
  std::vector<PlaneCell> cells;
  for (const Trapezoid& trapezoid : rings.umbra) cells.push_back(make_trapezoid(trapezoid, 1.0F));
  for (const ShadedTriangle& t : triangulate_rings(rings).strips) {
    const auto& v = rings.vertices;
    cells.push_back(
        make_triangle({v[t.corners[0]], v[t.corners[1]], v[t.corners[2]]}, {1.0F, 1.0F, 1.0F}));
  }
  return cells;
}

// Every corner is at a pixel's centre, so centres lie on sides and in corners all the time: of the
// cells that tile a square each must still belong to one.
TEST_F(PlaneCanvas, CellsThatMeetShareNoPixelAndLeaveNone) {
  Random random(631);
  const std::vector<GridSegment> square = loop({{centre(-24), centre(-24)},
                                                {centre(20), centre(-24)},
                                                {centre(20), centre(20)},
                                                {centre(-24), centre(20)}});
  const Visibility whole = draw(cells_of({square}));
  EXPECT_EQ(whole.accesses.li_writes, 44U * 44U);
  for (int i = 0; i < 100; ++i) {
    std::vector<std::vector<GridSegment>> outlines{square};
    for (int j = random.whole(1, 4); j > 0; --j) {
      std::vector<GridPoint> points;
      for (int k = random.whole(3, 8); k > 0; --k) {
        points.push_back({centre(random.whole(-24, 20)), centre(random.whole(-24, 20))});
      }
      outlines.push_back(outline_of_union(loop(points)));
    }
    const Visibility parts = draw(cells_of(outlines));
    ASSERT_EQ(parts.values, whole.values) << "case " << i;
    ASSERT_EQ(parts.accesses.li_writes, whole.accesses.li_writes) << "case " << i;
  }
}

TEST_F(PlaneCanvas, IntensityIsLinearBetweenCorners) {
  const Visibility drawn = draw({make_triangle(
      {GridPoint{-100, -100}, GridPoint{100, -100}, GridPoint{-100, 100}}, {0.0F, 1.0F, 0.5F})});
  int inside = 0;
  for (int y = 0; y < kSize; ++y) {
    for (int x = 0; x < kSize; ++x) {
      const glm::dvec3 way = world_point(window, x + 0.5, y + 0.5, 0.0) - window.eye;
      const glm::dvec3 p = plane.from_world(window.eye - window.eye.y / way.y * way) / plane.unit;
      const double u = (p.x + 100) / 200;
      const double v = (p.y + 100) / 200;
      const float value = drawn.values[static_cast<std::size_t>(y * kSize + x)];
      if (u > 0.01 && v > 0.01 && u + v < 0.99) {
        EXPECT_NEAR(value, 1.0 - u - 0.5 * v, 1e-6);
        ++inside;
      } else if (u < -0.01 || v < -0.01 || u + v > 1.01) {
        EXPECT_EQ(value, 1.0F);
      }
    }
  }
  EXPECT_GT(inside, 1000);
}

// Cells that reach behind the eye are drawn as far as they are seen.
TEST_F(PlaneCanvas, CellsBehindTheEyeAreCutOff) {
  scene.camera = {{0, 1, 0}, {0, 0.8, -4}, {0, 1, 0}, 45, 0.1, 50};
  window = make_window(scene.camera, kSize, kSize);
  depth = render_depth(window, scene.objects, traces::fb::DepthFormat_float32);
  plane.unit = 1e-6;
  const std::int32_t far = 9'000'000;
  const Visibility drawn =
      draw(cells_of({loop({{-far, -far}, {far, -far}, {far, far}, {-far, far}})}));
  for (std::size_t i = 0; i < drawn.values.size(); ++i) {
    if (depth.triangle[i] == DepthBuffer::kSky) {
      ASSERT_EQ(drawn.values[i], 1.0F) << i;
      continue;
    }
    const double z = traces::decode_depth(depth.format, depth.words[i]);
    const glm::dvec3 p = world_point(window, static_cast<double>(i % kSize) + 0.5,
                                     static_cast<double>(i / kSize) + 0.5, z);
    const double reach = std::max(std::abs(p.x), std::abs(p.z));
    ASSERT_TRUE(reach > 8.9 || drawn.values[i] == 0.0F) << i;
    ASSERT_TRUE(reach < 9.1 || drawn.values[i] == 1.0F) << i;
  }
}

}  // namespace
}  // namespace wedgesim::functional
