#include "functional/geometry/rings.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "functional/geometry/plane_shadow.h"
#include "functional/geometry/ring_strips.h"
#include "functional/geometry/segment.h"
#include "functional/scene/primitives.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

__extension__ using Wide = __int128;

// Casters over a floor at y = 0.
Scene make_scene(std::vector<Mesh> casters) {
  Scene scene;
  scene.light.centre = {0.0, 10.0, 0.0};
  scene.objects.push_back({make_plane({20.0, 20.0}, {2, 2}), false, {}});
  for (Mesh& mesh : casters) scene.objects.push_back({std::move(mesh), true, {}});
  return scene;
}

Mesh moved(Mesh mesh, const glm::dvec3& by) {
  for (glm::dvec3& p : mesh.positions) p += by;
  return mesh;
}

// Merged outlines, triangulated.
struct Merged {
  explicit Merged(const std::vector<std::vector<GridSegment>>& silhouettes)
      : rings(merge_silhouettes(silhouettes)), triangles(triangulate_rings(rings)) {}

  // Twice the area of {at least k hidden}, by the outline of ring k.
  Wide ring_area(int k) const {
    Wide sum = 0;
    for (const Rings::Edge& edge : rings.edges) {
      const auto [outside, inside] = std::minmax(edge.below, edge.above);
      if (k <= outside || k > inside) continue;
      const GridPoint& a = rings.vertices[edge.begin];
      const GridPoint& b = rings.vertices[edge.end];
      const Wide cross = Wide{a.x} * b.y - Wide{a.y} * b.x;
      sum += edge.above > edge.below ? cross : -cross;
    }
    return sum;
  }

  Rings rings;
  RingTriangles triangles;
};

struct Shadows : Merged {
  Shadows(const Scene& scene, const std::vector<glm::dvec3>& lights)
      : Shadows(scene, lights, find_receiver_plane(scene)) {}
  Shadows(const Scene& scene, const std::vector<glm::dvec3>& lights, ReceiverPlane over)
      : Merged(silhouettes(scene, lights, over)), samples(lights), plane(over) {}

  static std::vector<std::vector<GridSegment>> silhouettes(const Scene& scene,
                                                           const std::vector<glm::dvec3>& lights,
                                                           ReceiverPlane& plane) {
    const PlaneShadow shadow(scene, plane, lights);
    std::vector<std::vector<GridSegment>> result;
    for (const glm::dvec3& light : lights) result.push_back(shadow.silhouette(light));
    return result;
  }
  double to_area(Wide doubled) const {
    return 0.5 * plane.unit * plane.unit * static_cast<double>(doubled);
  }

  std::vector<glm::dvec3> samples;
  ReceiverPlane plane;
};

// The strips tile the areas between the rings: exactly their size, every one turned the right way.
void expect_tiled(const Merged& shadows, const std::string& where) {
  const Rings& rings = shadows.rings;
  std::vector<Wide> filled(static_cast<std::size_t>(rings.samples) + 1, 0);
  for (const ShadedTriangle& t : shadows.triangles.strips) {
    const std::int64_t area = turn(rings.vertices[t.corners[0]], rings.vertices[t.corners[1]],
                                   rings.vertices[t.corners[2]]);
    ASSERT_GT(area, 0) << where;
    filled[static_cast<std::size_t>(t.hidden)] += area;
  }
  for (int k = 1; k < rings.samples; ++k) {
    const Wide expected = shadows.ring_area(k) - shadows.ring_area(k + 1);
    ASSERT_TRUE(filled[static_cast<std::size_t>(k)] == expected) << where << ", ring " << k;
  }
  // Next to a crossing the outermost and the innermost ring have their own intensity.
  for (const Rings::Edge& edge : rings.edges) {
    const auto [outside, inside] = std::minmax(edge.below, edge.above);
    const bool both = rings.points[edge.begin].crossing && rings.points[edge.end].crossing;
    ASSERT_FALSE(both && (outside == 0 || inside == rings.samples)) << where;
  }
}

// How many of the drawn areas hold a point, and how many samples the last of them says are hidden.
struct Found {
  int areas = 0;
  int hidden = 0;
};
Found find(const Shadows& shadows, const GridPoint& p) {
  Found found;
  for (const Trapezoid& t : shadows.rings.umbra) {
    if (p.x >= t.x_begin && p.x < t.x_end && turn(t.lower[0], t.lower[1], p) > 0 &&
        turn(t.upper[0], t.upper[1], p) < 0) {
      ++found.areas;
      found.hidden = shadows.rings.samples;
    }
  }
  for (const ShadedTriangle& t : shadows.triangles.strips) {
    const GridPoint& a = shadows.rings.vertices[t.corners[0]];
    const GridPoint& b = shadows.rings.vertices[t.corners[1]];
    const GridPoint& c = shadows.rings.vertices[t.corners[2]];
    if (turn(a, b, p) > 0 && turn(b, c, p) > 0 && turn(c, a, p) > 0) {
      ++found.areas;
      found.hidden = t.hidden;
    }
  }
  return found;
}

int hidden_by_rays(const Scene& scene, const std::vector<glm::dvec3>& samples,
                   const glm::dvec3& p) {
  int hidden = 0;
  for (const glm::dvec3& sample : samples) {
    bool hit = false;
    for (const Object& object : scene.objects) {
      if (!object.casts) continue;
      const auto& v = object.mesh.positions;
      hit = hit || std::ranges::any_of(object.mesh.triangles, [&](const auto& t) {
              return segment_triangle(p, sample, v[t[0]], v[t[1]], v[t[2]]).has_value();
            });
    }
    hidden += hit ? 1 : 0;
  }
  return hidden;
}

// At random points of the floor, as many samples are hidden as rays say; near an edge of a shadow,
// where points around see different numbers, nothing is asked.
void expect_rays_agree(const Scene& scene, const Shadows& shadows, Random& random, int points,
                       const std::string& where) {
  int asked = 0;
  for (int i = 0; i < points; ++i) {
    const double reach = kGridLimit / 2.0;
    const GridPoint p{2 * static_cast<std::int32_t>(random.uniform(-reach, reach) / 2) + 1,
                      2 * static_cast<std::int32_t>(random.uniform(-reach, reach) / 2) + 1};
    const auto hidden_at = [&](double dx, double dy) {
      return hidden_by_rays(
          scene, shadows.samples,
          shadows.plane.to_world(shadows.plane.unit * glm::dvec2(p.x + dx * 64, p.y + dy * 64)));
    };
    const int expected = hidden_at(0, 0);
    if (hidden_at(1, 0) != expected || hidden_at(-1, 0) != expected ||
        hidden_at(0, 1) != expected || hidden_at(0, -1) != expected) {
      continue;
    }
    ++asked;
    const Found found = find(shadows, p);
    ASSERT_EQ(found.hidden, expected) << where << ", point " << p.x << ' ' << p.y;
    ASSERT_EQ(found.areas, expected > 0 ? 1 : 0) << where << ", point " << p.x << ' ' << p.y;
  }
  EXPECT_GT(asked, points / 2) << where;
}

std::vector<glm::dvec3> lights_about(Random& random, const glm::dvec3& centre, double size,
                                     int count) {
  std::vector<glm::dvec3> lights;
  for (int i = 0; i < count; ++i) {
    lights.push_back(centre + size * random.in_box({-1, -0.2, -1}, {1, 0.2, 1}));
  }
  return lights;
}

// A flat square over the floor: shadows are squares, moved with the lights; what k of them share is
// known.
TEST(Rings, AreasOfAMovingSquare) {
  const Mesh square = moved(make_thin_polygon({{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}), {0, 5, 0});
  // Lights at height 10: twice the size, moved the other way by as much as the light.
  const Shadows shadows(make_scene({square}), {{0, 10, 0}, {0.5, 10, 0.25}, {-0.25, 10, 0.5}});
  ASSERT_EQ(shadows.rings.samples, 3);
  expect_tiled(shadows, "square");
  // Squares of side 4 about (0, 0), (-0.5, -0.25), (0.25, -0.5); inclusion and exclusion.
  const auto common = [](double dx, double dy) { return (4 - dx) * (4 - dy); };
  const double all = common(0.75, 0.5);
  const double pairs = common(0.5, 0.25) + common(0.25, 0.5) + common(0.75, 0.25);
  EXPECT_NEAR(shadows.to_area(shadows.ring_area(3)), all, 1e-6);
  EXPECT_NEAR(shadows.to_area(shadows.ring_area(2)), pairs - 2 * all, 1e-6);
  EXPECT_NEAR(shadows.to_area(shadows.ring_area(1)), 48 - pairs + all, 1e-6);
}

TEST(Rings, IntensityRisesFromRingToRing) {
  const Mesh square = moved(make_thin_polygon({{-1, 1}, {1, 1}, {1, -1}, {-1, -1}}), {0, 5, 0});
  const Shadows shadows(make_scene({square}), {{0, 10, 0}, {0.5, 10, 0.25}, {-0.25, 10, 0.5}});
  int corners = 0;
  int crossings = 0;
  for (std::uint32_t v = 0; v < shadows.rings.vertices.size(); ++v) {
    const Rings::Point& point = shadows.rings.points[v];
    if (point.crossing) {
      ++crossings;
      ASSERT_EQ(point.highest, point.lowest + 1);
      for (int count = 0; count <= 3; ++count) {
        EXPECT_DOUBLE_EQ(intensity(shadows.rings, v, count), (point.lowest - 0.5) / 2.0);
      }
    } else {
      ++corners;
      ASSERT_EQ(point.lowest, point.highest);
      EXPECT_DOUBLE_EQ(intensity(shadows.rings, v, point.lowest), (point.lowest - 1) / 2.0);
    }
  }
  EXPECT_GE(corners, 12) << "and middles between crossings";
  EXPECT_EQ(crossings, 6);
  EXPECT_FALSE(shadows.triangles.mends.empty());
}

// Where three outlines coincide, the areas beside them see the first ring and the last.
TEST(Rings, CoincidentOutlinesMakeAStep) {
  const std::vector<std::vector<GridSegment>> outlines(
      3, {{{0, 0}, {100, 0}, 1}, {{100, 0}, {0, 100}, 1}, {{0, 100}, {0, 0}, 1}});
  const Rings rings = merge_silhouettes(outlines);
  ASSERT_EQ(rings.vertices.size(), 3U);
  EXPECT_EQ(intensity(rings, 0, 0), 0.0);
  EXPECT_EQ(intensity(rings, 0, 3), 1.0);
  EXPECT_TRUE(triangulate_rings(rings).strips.empty());
  EXPECT_FALSE(rings.umbra.empty());
}

TEST(Rings, AHoleStaysOpen) {
  const Scene scene = make_scene({moved(make_torus(1.0, 0.3, 32, 12), {0, 3, 0})});
  Random random(621);
  const Shadows shadows(scene, lights_about(random, {0, 10, 0}, 0.5, 5));
  EXPECT_EQ(find(shadows, {1, 1}).areas, 0) << "the hole's middle is lit";
  expect_tiled(shadows, "torus");
  expect_rays_agree(scene, shadows, random, 300, "torus");
}

TEST(Rings, ACasterThatGoesThroughTheFloorIsCutThere) {
  const Scene scene =
      make_scene({make_box({1, 4, 1}), moved(make_sphere(1.0, 12, 7), {3, 0.2, 1})});
  Scene sunk = scene;
  for (glm::dvec3& p : sunk.objects[1].mesh.positions) p.y -= 1.0;
  Random random(622);
  const Shadows shadows(sunk, lights_about(random, {1, 9, -2}, 0.6, 4));
  expect_tiled(shadows, "sunk");
  expect_rays_agree(sunk, shadows, random, 400, "sunk");
}

TEST(Rings, ACasterUnderTheFloorHasNoShadow) {
  const Shadows shadows(make_scene({moved(make_box({1, 1, 1}), {0, -3, 0})}), {{0, 10, 0}});
  EXPECT_TRUE(shadows.rings.edges.empty());
}

// Crumpled spheres, standing apart and in each other's shadow, some sunk into the floor.
TEST(Rings, RandomMeshes) {
  Random random(623);
  for (int i = 0; i < 25; ++i) {
    std::vector<Mesh> casters;
    const int count = random.whole(1, 3);
    for (int j = 0; j < count; ++j) {
      Mesh mesh = make_sphere(random.uniform(0.3, 1.0), random.whole(3, 12), random.whole(2, 8));
      for (glm::dvec3& p : mesh.positions) p *= random.uniform(0.5, 1.5);
      casters.push_back(moved(mesh, random.in_box({-2, 0, -2}, {2, 3, 2})));
    }
    const Scene scene = make_scene(casters);
    const Shadows shadows(scene, lights_about(random, random.in_box({-3, 7, -3}, {3, 12, 3}),
                                              random.uniform(0.01, 2.0), random.whole(1, 9)));
    const std::string where = "case " + std::to_string(i);
    expect_tiled(shadows, where);
    expect_rays_agree(scene, shadows, random, 60, where);
  }
}

// Outlines on a grid so coarse that most edges coincide with others or touch them.
TEST(Rings, RandomOutlinesOnACoarseGrid) {
  Random random(625);
  for (int i = 0; i < 2000; ++i) {
    std::vector<std::vector<GridSegment>> outlines(static_cast<std::size_t>(random.whole(1, 6)));
    const int range = random.whole(2, 12);
    for (auto& outline : outlines) {
      std::vector<GridSegment> loop;
      std::vector<GridPoint> points;
      const int corners = random.whole(3, 16);
      for (int j = 0; j < corners; ++j) {
        points.push_back({2 * random.whole(-range, range), 2 * random.whole(-range, range)});
      }
      for (std::size_t j = 0; j < points.size(); ++j) {
        loop.push_back({points[j], points[(j + 1) % points.size()], 1});
      }
      outline = outline_of_union(loop);
    }
    expect_tiled(Merged(outlines), "case " + std::to_string(i));
  }
}

// What is degenerate: samples twice, all at one place, boxes face to face and on the floor, edges
// towards the light, blades without thickness.
TEST(Rings, DegenerateInput) {
  Random random(624);
  const glm::dvec3 light(0.5, 8.0, 0.5);
  const std::vector<std::pair<std::string, Scene>> scenes{
      {"on the floor", make_scene({make_box({1, 1, 1})})},
      {"face to face", make_scene({make_box({1, 1, 1}), moved(make_box({1, 1, 1}), {1, 0, 0}),
                                   moved(make_box({1, 1, 1}), {1, 1, 0})})},
      {"twice the same", make_scene({make_box({1, 2, 1}), make_box({1, 2, 1})})},
      {"under the light's edge", make_scene({moved(make_box({1, 2, 1}), {0, 1, 0})})},
      {"blade", make_scene({moved(make_box({3, 1, 1e-9}), {0, 1, 0})})},
      {"needle",
       make_scene({moved(make_thin_polygon({{-2, 1e-8}, {2, 1e-8}, {2, -1e-8}, {-2, -1e-8}}),
                         {0.3, 1, 0.2})})},
      {"slivers", make_scene({moved(make_sphere(1.0, 200, 3), {0, 2, 0})})}};
  for (const auto& [name, scene] : scenes) {
    for (const double size : {0.0, 1e-9, 0.5}) {
      const std::vector<glm::dvec3> lights{light,
                                           light,
                                           light + size * glm::dvec3(1, 0, 0),
                                           light + size * glm::dvec3(1, 0, 1),
                                           light + size * glm::dvec3(0, 0, 1),
                                           light + size * glm::dvec3(0.5, 0, 0.5)};
      const Shadows shadows(scene, lights);
      const std::string where = name + ", light " + std::to_string(size);
      expect_tiled(shadows, where);
      expect_rays_agree(scene, shadows, random, 100, where);
    }
  }
}

TEST(PlaneShadow, RefusesWhatHasNoShadowOnThePlane) {
  const Scene scene = make_scene({moved(make_box({1, 1, 1}), {0, 2, 0})});
  ReceiverPlane plane = find_receiver_plane(scene);
  const auto casting = [&](const glm::dvec3& light) {
    PlaneShadow(scene, plane, std::vector<glm::dvec3>{light});
  };
  EXPECT_NO_THROW(casting({0, 10, 0}));
  EXPECT_THROW(casting({0, -1, 0}), InputError);
  EXPECT_THROW(casting({3, 2.5, 0}), InputError);
  EXPECT_THROW(casting({3, 3.0, 0}), InputError);
}

TEST(FindReceiverPlane, TakesOnePlaneAlone) {
  Scene scene = make_scene({make_box({1, 1, 1})});
  EXPECT_EQ(find_receiver_plane(scene).normal, glm::dvec3(0, 1, 0));
  scene.light.centre.y = -5.0;
  EXPECT_EQ(find_receiver_plane(scene).normal, glm::dvec3(0, -1, 0)) << "towards the light";
  scene.objects[0].mesh.positions[0].y = 1e-3;
  EXPECT_THROW(find_receiver_plane(scene), InputError);
  scene.objects.erase(scene.objects.begin());
  EXPECT_THROW(find_receiver_plane(scene), InputError) << "nothing receives";
}

}  // namespace
}  // namespace wedgesim::functional
