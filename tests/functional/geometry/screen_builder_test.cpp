#include "functional/geometry/screen_builder.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <set>
#include <tuple>

#include "functional/raster/spans.h"
#include "tests/functional/geometry/penumbra.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

constexpr int kWidth = 96;
constexpr int kHeight = 64;

// Somewhere around the shadows, looking at them.
Window random_window(Random& random) {
  for (;;) {
    Camera camera;
    camera.eye = random.in_box({-9.0, 0.5, -9.0}, {9.0, 8.0, 9.0});
    camera.target = random.in_box({-2.0, 0.0, -2.0}, {2.0, 4.0, 2.0});
    camera.field_of_view_degrees = random.uniform(10.0, 80.0);
    camera.near_plane = 0.2;
    camera.far_plane = 60.0;
    if (glm::distance(camera.eye, camera.target) > 1.0) {
      return make_window(camera, kWidth, kHeight);
    }
  }
}

std::vector<SnappedPoint> outline_of(const traces::Trace& trace, std::uint32_t first,
                                     std::uint32_t count) {
  std::vector<SnappedPoint> outline;
  for (std::uint32_t i = first; i < first + count; ++i) {
    const fb::ScreenVertex& v = trace.vertices[trace.indices[i]];
    outline.push_back({v.x(), v.y(), v.z()});
  }
  return outline;
}

struct Covered {
  std::vector<int> facing = std::vector<int>(kWidth * kHeight);
  std::vector<int> away = std::vector<int>(kWidth * kHeight);
};

Covered cover(const traces::Trace& trace, const fb::Wedge& wedge) {
  Covered covered;
  for (std::uint32_t f = wedge.first_face(); f < wedge.first_face() + wedge.face_count(); ++f) {
    const fb::Face& face = trace.faces[f];
    const auto outline = outline_of(trace, face.first_index(), face.index_count());
    auto& counts = doubled_area(outline) < 0 ? covered.facing : covered.away;
    for_each_span(outline, kWidth, 0, kHeight, [&](int y, int x0, int x1) {
      for (int x = x0; x < x1; ++x) ++counts[static_cast<std::size_t>(y * kWidth + x)];
    });
  }
  return covered;
}

// The part of the ray through a pixel centre that is inside all planes, as window depths; empty if
// low > high.
std::pair<double, double> depths_inside(const traces::Trace& trace, const fb::Wedge& wedge, int x,
                                        int y) {
  double low = 0.0;
  double high = 1.0;
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    const std::uint32_t reference = (*wedge.planes())[i];
    const fb::Plane& p = trace.planes[traces::plane_index(reference)];
    const double sign = traces::is_minus(reference) ? -1.0 : 1.0;
    const double v = sign * (p.a() * (x + 0.5) + p.b() * (y + 0.5) + p.d());
    const double slope = sign * p.c();
    if (slope > 0.0) low = std::max(low, -v / slope);
    if (slope < 0.0) high = std::min(high, -v / slope);
    if (slope == 0.0 && v < 0.0) high = -1.0;
  }
  return {low, high};
}

// Is every pixel whose ray meets the inside of a wedge covered by a face that faces the eye and by
// one that does not (by the latter alone where the near plane cuts), its depths in the interval?
TEST(ScreenBuilder, FacesCoverEveryPixelInside) {
  Random random(121);
  int wedges = 0;
  int clipped = 0;
  std::int64_t inside = 0;
  std::int64_t covered_pixels = 0;
  for (int i = 0; i < 3000; ++i) {
    const Window window = random_window(random);
    const EdgeCase edge =
        random_edge(random, random.chance(0.5) ? LightShape::rectangle : LightShape::sphere);
    const WorldWedge volume = coverage_wedge(edge.light, edge.begin, edge.end, edge.end_plane);
    traces::Trace trace;
    ScreenBuilder builder(window, trace);
    fb::Wedge wedge;
    if (volume.faces.empty() || !builder.add_faces(volume, wedge)) continue;
    ++wedges;
    const bool near_cuts =
        std::any_of(volume.vertices.begin(), volume.vertices.end(), [&](const glm::dvec3& p) {
          return (window.window_from_world * glm::dvec4(p, 1.0)).z < 0.0;
        });
    clipped += near_cuts ? 1 : 0;
    const Covered covered = cover(trace, wedge);
    for (int y = 0; y < kHeight; ++y) {
      for (int x = 0; x < kWidth; ++x) {
        const auto pixel = static_cast<std::size_t>(y * kWidth + x);
        if (covered.facing[pixel] + covered.away[pixel] > 0) ++covered_pixels;
        const auto [low, high] = depths_inside(trace, wedge, x, y);
        if (!(high - low > 1e-9)) continue;
        ++inside;
        ASSERT_LE(wedge.z_min(), low) << "case " << i;
        // The far plane does not clip: what is beyond it is beyond 1.
        ASSERT_GE(wedge.z_max(), std::min(high, 1.0)) << "case " << i;
        ASSERT_GE(covered.away[pixel], 1)
            << "case " << i << ", pixel " << x << ' ' << y << ": " << edge;
        if (!near_cuts) {
          ASSERT_GE(covered.facing[pixel], 1)
              << "case " << i << ", pixel " << x << ' ' << y << ": " << edge;
        }
      }
    }
  }
  std::cout << wedges << " wedges, " << clipped << " cut by the near plane; " << inside
            << " pixels inside, " << covered_pixels << " covered\n";
  EXPECT_GT(wedges, 2000);
  EXPECT_GT(inside, 500000);
  EXPECT_LT(static_cast<double>(covered_pixels - inside), 0.05 * static_cast<double>(inside));
}

// Are a plane and its opposite one entry, referenced with opposite signs, whatever is asked first?
TEST(ScreenBuilder, PlanesAreStoredOnce) {
  Random random(122);
  const Window window = random_window(random);
  traces::Trace trace;
  ScreenBuilder builder(window, trace);
  std::set<std::uint32_t> indices;
  for (int i = 0; i < 200; ++i) {
    glm::dvec4 plane(random.direction(), random.uniform(-5.0, 5.0));
    if (i % 5 == 0) plane.x = i % 2 == 0 ? 0.0 : -0.0;
    const std::uint32_t one = builder.plane_reference(plane);
    const std::uint32_t other = builder.plane_reference(-plane);
    ASSERT_EQ(one ^ 1U, other);
    ASSERT_EQ(builder.plane_reference(plane), one);
    indices.insert(traces::plane_index(one));
    // A plus reference is inside where the stored value is not negative.
    const fb::Plane& stored = trace.planes[traces::plane_index(one)];
    const glm::dvec3 p = world_point(window, 30.0, 20.0, 0.9);
    const double value = stored.a() * 30.0 + stored.b() * 20.0 + stored.c() * 0.9 + stored.d();
    ASSERT_EQ((value >= 0.0) != traces::is_minus(one),
              glm::dot(glm::dvec3(plane), p) + plane.w >= 0.0);
  }
  EXPECT_EQ(indices.size(), 200U);
  EXPECT_EQ(trace.planes.size(), 200U);
}

TEST(ScreenBuilder, VerticesAreStoredOnce) {
  Random random(123);
  const Window window = random_window(random);
  traces::Trace trace;
  ScreenBuilder builder(window, trace);
  for (int i = 0; i < 50; ++i) {
    const EdgeCase edge = random_edge(random, LightShape::rectangle);
    const WorldWedge volume = coverage_wedge(edge.light, edge.begin, edge.end, edge.end_plane);
    fb::Wedge wedge;
    builder.add_faces(volume, wedge);
  }
  std::set<std::tuple<int, int, double>> seen;
  for (const fb::ScreenVertex& v : trace.vertices) {
    EXPECT_TRUE(seen.insert({v.x(), v.y(), v.z()}).second);
  }
  EXPECT_GT(trace.indices.size(), trace.vertices.size());
}

// Quads with a common edge, seen from everywhere: is what they cover together what their outline
// encloses, each pixel as often facing as its parts say, and does one part at most name the wedge?
TEST(ScreenBuilder, UmbraPolygonsAreConvexParts) {
  Random random(124);
  int parts = 0;
  for (int i = 0; i < 5000; ++i) {
    const Window window = random_window(random);
    // Nearly edge-on quads snap into outlines that are not convex.
    const glm::dvec3 a = random.in_box({-3.0, 0.0, -3.0}, {3.0, 4.0, 3.0});
    const glm::dvec3 along = random.uniform(0.1, 3.0) * random.direction();
    const glm::dvec3 to_eye = window.eye - a;
    const glm::dvec3 aside =
        random.uniform(0.1, 0.9) * to_eye + random.uniform(-0.02, 0.02) * random.direction();
    const std::array<glm::dvec3, 4> quad{a, a + along, a + along + aside, a + aside};
    traces::Trace trace;
    ScreenBuilder builder(window, trace);
    const std::uint32_t plane = builder.plane_reference(glm::dvec4(0, 1, 0, 1));
    const std::uint32_t index = builder.add_umbra_polygon(quad, plane, 7, 3, fb::UmbraRole_side);
    if (index == traces::kNone) continue;
    ASSERT_EQ(index, 0U);
    std::int64_t area = 0;
    for (std::size_t k = 0; k < trace.umbra_polygons.size(); ++k) {
      const fb::UmbraPolygon& part = trace.umbra_polygons[k];
      const auto outline = outline_of(trace, part.first_index(), part.index_count());
      ASSERT_GE(outline.size(), 3U);
      ASSERT_TRUE(is_convex(outline));
      ASSERT_EQ(part.wedge(), k == 0 ? 7U : traces::kNone);
      ASSERT_EQ(part.caster(), 3U);
      ASSERT_EQ(part.plane(), plane);
      for (const SnappedPoint& p : outline) {
        ASSERT_GE(p.z, part.z_min());
        ASSERT_LE(p.z, part.z_max());
      }
      area += doubled_area(outline);
    }
    ASSERT_EQ(area, doubled_area(snap(clip_to_window(window, quad)))) << "case " << i;
    if (trace.umbra_polygons.size() > 1) ++parts;
  }
  EXPECT_GT(parts, 50);
}

// Does a wedge reach to the eye that stands in it, where its sides are beyond the guard band?
TEST(ScreenBuilder, WedgesAroundTheEyeBeginAtTheNearPlane) {
  Camera camera;
  camera.target = {0.0, 0.0, -1.0};
  camera.field_of_view_degrees = 1e-3;
  camera.near_plane = 0.5;
  camera.far_plane = 100.0;
  WorldWedge volume;
  volume.planes = {{1, 0, 0, 100}, {-1, 0, 0, 100}, {0, 1, 0, 100}, {0, -1, 0, 100}, {0, 0, 1, 50}};
  for (const double z : {100.0, -50.0}) {
    for (const glm::dvec2 p : {glm::dvec2(-100, -100), {100, -100}, {100, 100}, {-100, 100}}) {
      volume.vertices.emplace_back(p, z);
    }
  }
  volume.faces = {{0, {0, 3, 7, 4}},
                  {1, {1, 5, 6, 2}},
                  {2, {0, 4, 5, 1}},
                  {3, {3, 2, 6, 7}},
                  {4, {4, 7, 6, 5}}};
  const auto depths_from = [&](const glm::dvec3& eye) {
    camera.target += eye - camera.eye;
    camera.eye = eye;
    const Window window = make_window(camera, kWidth, kHeight);
    traces::Trace trace;
    fb::Wedge wedge;
    EXPECT_TRUE(ScreenBuilder(window, trace).add_faces(volume, wedge));
    EXPECT_EQ(wedge.face_count(), 1U);  // the bottom
    return std::pair(wedge.z_min(), window_depth(window, eye.z + 50.0) - wedge.z_min());
  };
  EXPECT_LE(depths_from({0.0, 0.0, 0.0}).first, 0.0);
  // From outside, the bottom behind it is all that is seen, too; but it is not in the wedge.
  volume.planes[0].w = -50.0;
  EXPECT_LT(depths_from({0.0, 0.0, 0.0}).second, 1e-6);
}

TEST(ScreenBuilder, NothingInFrontOfTheEyeIsNothing) {
  Random random(125);
  const Window window = random_window(random);
  const glm::dvec3 back = window.eye - world_point(window, kWidth / 2.0, kHeight / 2.0, 0.5);
  traces::Trace trace;
  ScreenBuilder builder(window, trace);
  const glm::dvec3 behind = window.eye + 10.0 * glm::normalize(back);
  const std::array<glm::dvec3, 3> triangle{behind, behind + glm::dvec3(1, 0, 0),
                                           behind + glm::dvec3(0, 1, 0)};
  EXPECT_EQ(builder.add_umbra_polygon(triangle, 0, 0, 0, fb::UmbraRole_cap), traces::kNone);
  WorldWedge volume;
  volume.planes = {glm::dvec4(0, 0, 1, 0)};
  volume.vertices.assign(triangle.begin(), triangle.end());
  volume.faces = {{0, {0, 1, 2}}};
  fb::Wedge wedge;
  EXPECT_FALSE(builder.add_faces(volume, wedge));
  EXPECT_TRUE(trace.vertices.empty());
  EXPECT_TRUE(trace.faces.empty());
}

}  // namespace
}  // namespace wedgesim::functional
