// Does `coverage` give the exact visible fraction of the light behind one thin planar polygon? A
// planar caster has one silhouette for all points of the light, so the sum of what its edges cover
// and its umbra must be the area of the polygon projected onto the light.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <numbers>

#include "functional/geometry/extent.h"
#include "functional/geometry/silhouette.h"
#include "functional/light/coverage.h"
#include "functional/methods/frame.h"
#include "functional/scene/scene_file.h"
#include "tests/functional/light/exact_area.h"

namespace wedgesim::functional {
namespace {

using Wide3 = glm::tvec3<long double>;

// A convex polygon in homogeneous coordinates of the light's plane, within |x|, |y| ≤ half.
LightPolygon within_square(std::vector<Wide3> polygon, long double half) {
  for (const Wide3& plane :
       {Wide3(-1, 0, half), Wide3(1, 0, half), Wide3(0, -1, half), Wide3(0, 1, half)}) {
    std::vector<Wide3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Wide3& p = polygon[i];
      const Wide3& q = polygon[(i + 1) % polygon.size()];
      const long double at_p = glm::dot(plane, p);
      const long double at_q = glm::dot(plane, q);
      if (at_p >= 0.0L) kept.push_back(p);
      if ((at_p >= 0.0L) != (at_q >= 0.0L)) kept.push_back(p + at_p / (at_p - at_q) * (q - p));
    }
    polygon = std::move(kept);
  }
  LightPolygon result;
  for (const Wide3& p : polygon) result.push_back({p.x / p.z, p.y / p.z});
  return result;
}

// The visible fraction of a light from a point below a convex planar polygon.
double exact_visibility(const Light& light, const std::vector<glm::dvec3>& outline,
                        const glm::dvec3& point) {
  const Wide3 p(point);
  const Wide3 centre(light.centre);
  std::vector<Wide3> projected;
  if (light.shape == LightShape::rectangle) {
    const Wide3 u = Wide3(light.half_u) / glm::dot(Wide3(light.half_u), Wide3(light.half_u));
    const Wide3 v = Wide3(light.half_v) / glm::dot(Wide3(light.half_v), Wide3(light.half_v));
    const Wide3 normal = glm::cross(u, v);
    const long double height = glm::dot(normal, p - centre);
    for (const glm::dvec3& corner : outline) {
      // p + t (corner − p) on the light's plane, t = height / w.
      const Wide3 way = Wide3(corner) - p;
      const long double w = -glm::dot(normal, way);
      projected.emplace_back(w * glm::dot(u, p - centre) + height * glm::dot(u, way),
                             w * glm::dot(v, p - centre) + height * glm::dot(v, way), w);
    }
    return 1.0 - static_cast<double>(std::abs(area_of(within_square(projected, 1.0L))) / 4.0L);
  }
  const long double distance = glm::length(centre - p);
  const long double radius = light.radius;
  const Wide3 axis = (centre - p) / distance;
  const Wide3 u = glm::normalize(glm::cross(axis, Wide3(0.3L, 0.2L, 0.9L)));
  const Wide3 v = glm::cross(axis, u);
  const long double tangent = radius / std::sqrt(distance * distance - radius * radius);
  for (const glm::dvec3& corner : outline) {
    const Wide3 way = Wide3(corner) - p;
    projected.emplace_back(glm::dot(way, u), glm::dot(way, v), tangent * glm::dot(way, axis));
  }
  const long double hidden = area_in_disc(within_square(projected, 1.25L));
  return 1.0 - static_cast<double>(std::abs(hidden) / std::numbers::pi_v<long double>);
}

double distance_to_segment(const glm::dvec2& p, const glm::dvec2& a, const glm::dvec2& b) {
  const glm::dvec2 way = b - a;
  const double t = std::clamp(glm::dot(p - a, way) / glm::dot(way, way), 0.0, 1.0);
  return glm::distance(p, a + t * way);
}

class ThinPolygon : public testing::TestWithParam<LightShape> {};

INSTANTIATE_TEST_SUITE_P(Lights, ThinPolygon,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

TEST_P(ThinPolygon, CoverageIsExact) {
  double worst = 0.0;
  int compared = 0;
  int excepted = 0;
  int penumbra = 0;
  for (const int frame_number : {0, 11, 23}) {
    SceneOptions scene_options;
    scene_options.frame = frame_number;
    scene_options.light_shape = GetParam();
    const Scene scene = load_scene("ground-polygon", scene_options);
    const Frame frame = make_frame(scene);
    const auto caster = std::find_if(scene.objects.begin(), scene.objects.end(),
                                     [](const Object& object) { return object.casts; });
    ASSERT_NE(caster, scene.objects.end());
    const Silhouette silhouette = find_silhouette(caster->mesh, scene.light.centre);
    ASSERT_EQ(silhouette.loops.size(), 1U);
    const EndPlane end = choose_end_plane(caster->mesh, silhouette, scene.light,
                                          bounds_of(scene.objects), std::nullopt);
    std::vector<glm::dvec3> outline;
    std::vector<std::pair<glm::dvec2, glm::dvec2>> rays;  // on the screen
    for (const SilhouetteEdge& edge : silhouette.loops[0]) {
      const glm::dvec3& corner = caster->mesh.positions[edge.begin];
      outline.push_back(corner);
      const auto project = [&](const glm::dvec3& q) {
        const glm::dvec4 h = frame.window.window_from_world * glm::dvec4(q, 1.0);
        EXPECT_GT(h.w, 0.0);
        return glm::dvec2(h) / h.w;
      };
      rays.emplace_back(project(corner), project(end.reach(scene.light.centre, corner)));
    }
    for (std::size_t pixel = 0; pixel < frame.depth.words.size(); ++pixel) {
      if (frame.depth.triangle[pixel] == DepthBuffer::kSky) continue;
      if (scene.objects[frame.depth.surface(pixel).object].casts) continue;
      const auto width = static_cast<std::size_t>(scene.width);
      const glm::dvec2 at(static_cast<double>(pixel % width) + 0.5,
                          static_cast<double>(pixel / width) + 0.5);
      const bool doubtful = std::any_of(rays.begin(), rays.end(), [&](const auto& ray) {
        return distance_to_segment(at, ray.first, ray.second) < 1.0 / 256.0;
      });
      if (doubtful) {
        ++excepted;
        continue;
      }
      const glm::dvec3 p =
          world_point(frame.window, at.x, at.y,
                      traces::decode_depth(frame.depth.format, frame.depth.words[pixel]));
      const double expected = exact_visibility(scene.light, outline, p);
      const double found = frame.trace.expected_li[pixel];
      worst = std::max(worst, std::abs(found - expected));
      ++compared;
      if (expected > 0.0 && expected < 1.0) ++penumbra;
      ASSERT_NEAR(found, expected, 1e-6)
          << "frame " << frame_number << ", pixel " << at.x << ' ' << at.y;
    }
  }
  std::cout << compared << " pixels, " << penumbra << " in the penumbra, " << excepted
            << " excepted; largest error " << worst << '\n';
  EXPECT_GT(penumbra, 10000);
  EXPECT_LT(excepted, 100);
}

}  // namespace
}  // namespace wedgesim::functional
