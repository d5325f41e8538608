#include "functional/geometry/linear_wedge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "functional/geometry/silhouette.h"
#include "functional/scene/primitives.h"
#include "tests/functional/geometry/closed_surface.h"
#include "tests/functional/geometry/penumbra.h"

namespace wedgesim::functional {
namespace {

double value(const glm::dvec4& plane, const glm::dvec3& p) {
  return glm::dot(glm::dvec3(plane), p) + plane.w;
}

struct LoopCase {
  Light light;
  std::vector<glm::dvec3> corners;
  EndPlane end_plane;
  Bounds box;
};

// The silhouette loop of a box or a sphere, seen from a light above.
LoopCase random_loop(Random& random, LightShape shape) {
  LoopCase loop;
  loop.light = random_light(random, shape);
  Mesh mesh = random.chance(0.5)
                  ? make_box(random.in_box({0.4, 0.4, 0.4}, {2.0, 2.0, 2.0}))
                  : make_sphere(random.uniform(0.3, 1.0), random.whole(5, 24), random.whole(3, 12));
  const glm::dvec3 place = random.in_box({-2.0, 1.6, -2.0}, {2.0, 4.0, 2.0});
  for (glm::dvec3& p : mesh.positions) p += place;
  const Silhouette silhouette = find_silhouette(mesh, loop.light.centre);
  Bounds bounds;
  bounds.grow(kReceiversLow);
  bounds.grow(kReceiversHigh);
  loop.end_plane = choose_end_plane(mesh, silhouette, loop.light, bounds, std::nullopt);
  for (const SilhouetteEdge& edge : silhouette.loops.front()) {
    loop.corners.push_back(mesh.positions[edge.begin]);
  }
  loop.box.grow(glm::dvec3(-100.0));
  loop.box.grow(glm::dvec3(100.0));
  return loop;
}

// Whether the line of an edge passes through a light.
bool line_hits(const Light& light, const glm::dvec3& begin, const glm::dvec3& end) {
  const glm::dvec3 way = end - begin;
  if (light.shape == LightShape::sphere) {
    const glm::dvec3 off = glm::cross(glm::normalize(way), light.centre - begin);
    return glm::length(off) < light.radius;
  }
  const glm::dvec3 normal = glm::cross(light.half_u, light.half_v);
  const double slope = glm::dot(normal, way);
  if (slope == 0.0) return false;
  const glm::dvec3 at = begin + glm::dot(normal, light.centre - begin) / slope * way - light.centre;
  const double u = glm::dot(at, light.half_u) / glm::dot(light.half_u, light.half_u);
  const double v = glm::dot(at, light.half_v) / glm::dot(light.half_v, light.half_v);
  return std::max(std::abs(u), std::abs(v)) < 1.0;
}

class LinearWedgeOfLight : public testing::TestWithParam<LightShape> {};

INSTANTIATE_TEST_SUITE_P(Lights, LinearWedgeOfLight,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

// Do neighbours have the same side plane, the other way round, and the same umbra corners, bit for
// bit?
TEST_P(LinearWedgeOfLight, NeighboursShareBits) {
  Random random(111);
  for (int i = 0; i < 500; ++i) {
    const LoopCase loop = random_loop(random, GetParam());
    const auto wedges = linear_wedges(loop.light, loop.corners, loop.end_plane, loop.box);
    ASSERT_GE(wedges.size(), 3U);
    for (std::size_t k = 0; k < wedges.size(); ++k) {
      const LinearWedge& one = wedges[k];
      const LinearWedge& next = wedges[(k + 1) % wedges.size()];
      ASSERT_EQ(one.end, next.begin);
      ASSERT_GE(one.volume.planes.size(), 5U);
      ASSERT_EQ(one.volume.planes[3], -next.volume.planes[2]) << "case " << i << ", wedge " << k;
      ASSERT_EQ(one.umbra[0], next.umbra[1]);
      ASSERT_EQ(one.umbra[3], next.umbra[2]);
      ASSERT_EQ(one.volume.planes[4], loop.end_plane.plane);
    }
  }
}

// Is the light on the lit side of the front plane and on the other of the back plane, both touching
// it, and both through the edge?
TEST_P(LinearWedgeOfLight, FrontAndBackTouchTheLight) {
  Random random(112);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const LoopCase loop = random_loop(random, GetParam());
    for (const LinearWedge& wedge :
         linear_wedges(loop.light, loop.corners, loop.end_plane, loop.box)) {
      const glm::dvec4& front = wedge.volume.planes[0];
      const glm::dvec4& back = wedge.volume.planes[1];
      for (const glm::dvec3& p : {wedge.begin, wedge.end}) {
        ASSERT_NEAR(value(front, p), 0.0, 1e-12);
        ASSERT_NEAR(value(back, p), 0.0, 1e-12);
      }
      if (line_hits(loop.light, wedge.begin, wedge.end)) continue;  // no plane leaves it aside
      ++compared;
      // How far the light's corners, or its centre, reach beyond each plane.
      double beyond_front = -1e300;
      double beyond_back = -1e300;
      for (const glm::dvec3& x : light_corners(loop.light)) {
        beyond_front = std::max(beyond_front, value(front, x));
        beyond_back = std::max(beyond_back, value(back, x));
      }
      if (GetParam() == LightShape::sphere) {
        // Paper I, 4.1: by the point of the sphere along the normal of the shadow quad, which is
        // nearer to the centre than the tangent plane.
        const glm::dvec3 along = glm::normalize(wedge.end - wedge.begin);
        const double h = glm::length(glm::cross(along, wedge.begin - loop.light.centre));
        const double r = loop.light.radius;
        beyond_front += r * h / std::hypot(r, h);
        beyond_back += r * h / std::hypot(r, h);
      }
      const double slack = 1e-9;
      ASSERT_NEAR(beyond_front, 0.0, slack) << "case " << i;
      ASSERT_NEAR(beyond_back, 0.0, slack) << "case " << i;
    }
  }
  EXPECT_GT(compared, 4000);
}

// Are the volumes closed and convex, and nearly all umbra polygons on their front planes?
TEST_P(LinearWedgeOfLight, VolumesAreClosed) {
  Random random(113);
  int volumes = 0;
  int polygons = 0;
  int flat = 0;  // where front planes meet too far aside, a corner is placed more simply
  for (int i = 0; i < 500; ++i) {
    const LoopCase loop = random_loop(random, GetParam());
    for (const LinearWedge& wedge :
         linear_wedges(loop.light, loop.corners, loop.end_plane, loop.box)) {
      double off = 0.0;
      for (const glm::dvec3& p : wedge.umbra) {
        off = std::max(off, std::abs(value(wedge.volume.planes[0], p)));
      }
      ++polygons;
      if (off < 1e-9) ++flat;
      if (wedge.volume.faces.empty()) continue;
      ++volumes;
      const SurfaceFaults faults = faults_of(wedge.volume);
      ASSERT_LT(faults.not_planar, 1e-9) << "case " << i;
      ASSERT_LT(faults.not_outside, 1e-9) << "case " << i;
      ASSERT_LT(faults.not_closed, 1e-9) << "case " << i;
      ASSERT_EQ(faults.wrong_way, 0) << "case " << i;
      ASSERT_EQ(faults.unmatched_edges, 0) << "case " << i;
    }
  }
  std::cout << flat << " of " << polygons << " umbra polygons lie in their front plane\n";
  EXPECT_GT(volumes, 4000);
  EXPECT_GT(flat, polygons * 9 / 10);
}

// Is the middle of the penumbra, behind the middle of an edge, inside its wedge, and is the wedge
// on the lit side of the umbra polygon's outline?
TEST_P(LinearWedgeOfLight, HoldsTheMiddleOfThePenumbra) {
  Random random(114);
  int held = 0;
  int all = 0;
  for (int i = 0; i < 500; ++i) {
    const LoopCase loop = random_loop(random, GetParam());
    for (const LinearWedge& wedge :
         linear_wedges(loop.light, loop.corners, loop.end_plane, loop.box)) {
      const glm::dvec3 middle = 0.5 * (wedge.begin + wedge.end);
      const glm::dvec3 p =
          middle + 0.2 * (loop.end_plane.reach(loop.light.centre, middle) - middle);
      bool inside = true;
      for (std::size_t k = 0; k < 5; ++k) inside &= value(wedge.volume.planes[k], p) >= 0.0;
      held += inside ? 1 : 0;
      ++all;
      ASSERT_GT(value(wedge.volume.planes[0], p), 0.0) << "case " << i;
      ASSERT_GT(value(wedge.volume.planes[1], p), 0.0) << "case " << i;
    }
  }
  std::cout << held << " of " << all << " wedges hold the middle of their penumbra\n";
  EXPECT_GT(held, all * 9 / 10);
}

struct CornerCase {
  const char* what;
  std::vector<glm::dvec3> loop;
};

// Do wedges end in the end plane where the planes of two edges meet in a line along it, and have
// they side planes where a loop turns back along its edge?
TEST(LinearWedge, CornersWithoutAMeetingTakeARay) {
  Light light;
  light.shape = LightShape::rectangle;
  light.half_u = {-0.25, 0.0, 0.0};
  light.half_v = {0.0, 0.0, -0.25};
  EndPlane end_plane;
  end_plane.plane = {0.0, 1.0, 0.0, 2.0};
  const Bounds bounds{glm::dvec3(-4.0, -2.0, -4.0), glm::dvec3(4.0, 0.0, 4.0)};
  const glm::dvec3 a(0.5, -1.0, 0.0);
  const glm::dvec3 b(0.0, -1.0, 0.5);
  const glm::dvec3 c(-0.5, -1.0, 0.0);
  const glm::dvec3 d(0.0, -1.0, -0.5);
  const glm::dvec3 o(0.0, -1.0, 0.0);
  const CornerCase cases[]{
      {"back along an edge", {a, b, a, c}},
      {"out and back", {a, b, c, b}},
      // The front planes of two edges along x and y meet along z, and the like.
      {"parallel to the end plane", {a, o, b, o, c, o, d, o}},
  };
  for (const CornerCase& corner_case : cases) {
    SCOPED_TRACE(corner_case.what);
    for (const LinearWedge& wedge : linear_wedges(light, corner_case.loop, end_plane, bounds)) {
      for (const glm::dvec4& plane : wedge.volume.planes) {
        EXPECT_NEAR(glm::length(glm::dvec3(plane)), 1.0, 1e-9);
      }
      for (const std::size_t far : {2U, 3U}) {
        EXPECT_NEAR(wedge.umbra[far].y, -2.0, 1e-9);
        EXPECT_LT(glm::length(wedge.umbra[far]), 100.0);
      }
    }
  }
}

// A corner so sharp that its edges are nearly in the side plane between them: which of them is on
// which side must not be rounding. What is right at 1e-7 rad is so at 4e-9.
TEST(LinearWedge, SidesOfSharpCorners) {
  Random random(115);
  for (int i = 0; i < 50; ++i) {
    Light light;
    light.centre = random.in_box({-2.0, 9.0, -2.0}, {2.0, 11.0, 2.0});
    light.half_u = {0.5, 0.0, 0.0};
    light.half_v = {0.0, 0.0, 0.5};
    const double turn = random.uniform(0.0, 2.0 * M_PI);
    const glm::dvec3 along(std::cos(turn), 0.0, std::sin(turn));
    const glm::dvec3 aside(-along.z, 0.0, along.x);
    const glm::dvec3 tip = random.in_box({-1.0, 3.0, -1.0}, {1.0, 5.0, 1.0});
    const auto side_at = [&](double angle) {
      const glm::dvec3 half = std::tan(0.5 * angle) * aside;
      const auto wedges =
          linear_wedges(light, {tip - along + half, tip, tip - along - half, tip - 2.0 * along},
                        {glm::dvec4(0.0, 1.0, 0.0, 0.0)}, {glm::dvec3(-50.0), glm::dvec3(50.0)});
      EXPECT_EQ(wedges.size(), 4U);
      EXPECT_EQ(wedges[1].corner.side, SideNormal::of_quads);
      return glm::dvec3(wedges[1].volume.planes[2]);
    };
    EXPECT_GT(glm::dot(side_at(4e-9), side_at(1e-7)), 0.999) << "case " << i;
  }
}

// A square beneath a light so near that rays are in the place of lines, and one side plane holds
// the edge that ends at it: is the edge that begins there on its own side?
TEST(LinearWedge, AnEdgeInTheSidePlaneLeavesTheOtherItsSide) {
  Light light;
  light.half_u = {-0.25, 0.0, 0.0};
  light.half_v = {0.0, 0.0, -0.25};
  constexpr double kHalf = 0x1.3cp-11;
  constexpr double kBelow = 0x1.cp-9;
  const std::vector<glm::dvec3> loop{{kHalf, -kBelow, kHalf},
                                     {kHalf, -kBelow, -kHalf},
                                     {-kHalf, -kBelow, -kHalf},
                                     {-kHalf, -kBelow, kHalf}};
  const Bounds bounds{glm::dvec3(-4.0, -2.0, -4.0), glm::dvec3(4.0, 0.0, 4.0)};
  const auto wedges = linear_wedges(light, loop, {glm::dvec4(0.0, 1.0, 0.0, 2.0)}, bounds);
  ASSERT_EQ(wedges.size(), 4U);
  int in_side = 0;
  for (const LinearWedge& wedge : wedges) {
    if (wedge.corner.sign != SideSign::of_starting) continue;
    ++in_side;
    EXPECT_GT(value(wedge.volume.planes[2], wedge.end), 0.0);
  }
  EXPECT_GT(in_side, 0);
}

// A point of the line in which two planes meet, in the plane through the origin across a way.
glm::dvec3 common_point(const glm::dvec4& a, const glm::dvec4& b, const glm::dvec3& way) {
  const glm::dvec3 m(a), n(b);
  return -(a.w * glm::cross(n, way) + b.w * glm::cross(way, m)) / glm::dot(m, glm::cross(n, way));
}

// A triangle with a vertex so far away that both its edges there are all but in the side plane
// between them. Near the light that plane still goes through the lines in which the front and the
// back planes meet, and leaves the edge that says so on its own side.
TEST_P(LinearWedgeOfLight, SidePlanesOfFarVertices) {
  Random random(116);
  const Bounds receivers{glm::dvec3(-0x1p31), glm::dvec3(0x1p31)};
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    Light light;
    light.shape = GetParam();
    light.radius = 0.25;
    light.half_u = {-0.25, 0.0, 0.0};
    light.half_v = {0.0, 0.0, -0.25};
    const double reach = std::exp2(random.uniform(20.0, 30.0));
    glm::dvec3 a = random.in_box({-1.0, -2.0, -1.0}, {1.0, -1.0, 1.0});
    glm::dvec3 b = random.in_box({-1.0, -2.0, -1.0}, {1.0, -1.0, 1.0});
    const glm::dvec3 far = reach * random.in_box({-1.0, -2.0, -1.0}, {1.0, -1.0, 1.0});
    const double turn = glm::dot(glm::normalize(glm::cross(b, a)), glm::normalize(far));
    if (std::abs(turn) < 0.1) continue;
    if (turn < 0.0) std::swap(a, b);
    const auto wedges =
        linear_wedges(light, {a, b, far}, {glm::dvec4(0.0, 1.0, 0.0, 0x1p31)}, receivers);
    if (wedges.size() != 3) continue;  // an edge points at the light
    const auto& ending = wedges[1].volume.planes;
    const auto& starting = wedges[2].volume.planes;
    const double own = value(ending[3], b) / glm::distance(b, far);
    const double others = value(starting[2], a) / glm::distance(a, far);
    const SideSign sign = wedges[2].corner.sign;
    ASSERT_GT(
        sign == SideSign::of_turn ? own + others : (sign == SideSign::of_ending ? own : others),
        0.0)
        << "case " << i;
    if (wedges[2].corner.side != SideNormal::of_lines) continue;
    for (const std::size_t k : {0U, 1U}) {
      if (wedges[2].corner.by_ray[k]) continue;
      const glm::dvec3 p = common_point(ending[k], starting[k], glm::normalize(far));
      ASSERT_NEAR(value(ending[3], p), 0.0, 1e-10) << "case " << i;
      ++compared;
    }
  }
  EXPECT_GT(compared, 400);
}

// Edges whose line goes through a corner of the light, as far as doubles tell: their planes are
// those of a line that passes it by next to nothing, not what is left of a vector without length.
TEST(LinearWedge, EdgesInLineWithACornerOfTheLight) {
  Random random(117);
  int compared = 0;
  for (int i = 0; i < 500; ++i) {
    const Light light = random_light(random, LightShape::rectangle);
    const glm::dvec3 corner = light.half_u + light.half_v;
    const glm::dvec3 way = random.direction() + 3.0 * glm::normalize(-light.centre);
    const glm::dvec3 third = random.in_box({-1.0, 0.0, -1.0}, {1.0, 1.0, 1.0});
    const auto planes_beside = [&](double beside) {
      const glm::dvec3 from = light.centre + (1.0 + beside) * corner;
      const auto wedges =
          linear_wedges(light, {from + way, from + 1.5 * way, third},
                        {glm::dvec4(0.0, 1.0, 0.0, 9.0)}, {glm::dvec3(-50.0), glm::dvec3(50.0)});
      return wedges.size() < 3 ? std::vector<glm::dvec4>() : wedges.front().volume.planes;
    };
    const auto through = planes_beside(0.0);
    const auto beside = planes_beside(1e-8);
    if (through.empty() || beside.empty()) continue;
    for (const std::size_t k : {0U, 1U}) {
      ASSERT_LT(glm::distance(glm::dvec3(through[k]), glm::dvec3(beside[k])), 1e-5)
          << "case " << i << ", plane " << k;
    }
    ++compared;
  }
  EXPECT_GT(compared, 100);
}

// No plane through an edge whose line meets the light touches it.
TEST(LinearWedge, EdgesThatPointIntoTheLightAreLeftOut) {
  Light light;
  light.centre = {0.0, 10.0, 0.0};
  light.half_u = {0.5, 0.0, 0.0};
  light.half_v = {0.0, 0.0, 0.5};
  light.radius = 0.5;
  Bounds box;
  box.grow(glm::dvec3(-50.0));
  box.grow(glm::dvec3(50.0));
  const EndPlane end{glm::dvec4(0, 1, 0, 0)};
  const auto edges_left = [&](const glm::dvec3& aimed_at) {
    const glm::dvec3 low(1.0, 2.0, 1.0);
    return linear_wedges(light,
                         {{-1, 2, 1}, low, low + 0.1 * (aimed_at - low), {1, 2, -1}, {-1, 2, -1}},
                         end, box)
        .size();
  };
  EXPECT_EQ(edges_left({0.48, 10.0, -0.48}), 4U) << "a corner of the rectangle";
  EXPECT_EQ(edges_left({0.48, 10.0, -0.52}), 5U);
  light.shape = LightShape::sphere;
  EXPECT_EQ(edges_left({0.34, 10.0, -0.34}), 4U);
  EXPECT_EQ(edges_left({0.48, 10.0, -0.48}), 5U) << "beside the sphere";
}

// An edge that points at the light is left out, its ends joined (Paper I, 8).
TEST(LinearWedge, EdgesThatPointAtTheLightAreLeftOut) {
  Light light;
  light.centre = {0.0, 10.0, 0.0};
  light.half_u = {0.5, 0.0, 0.0};
  light.half_v = {0.0, 0.0, 0.5};
  const glm::dvec3 low(1.0, 2.0, 1.0);
  const std::vector<glm::dvec3> loop{
      {-1, 2, 1}, low, low + 0.1 * (light.centre - low), {1, 2, -1}, {-1, 2, -1}};
  Bounds box;
  box.grow(glm::dvec3(-50.0));
  box.grow(glm::dvec3(50.0));
  const EndPlane end{glm::dvec4(0, 1, 0, 0)};
  const auto wedges = linear_wedges(light, loop, end, box);
  ASSERT_EQ(wedges.size(), 4U);
  for (const LinearWedge& wedge : wedges) {
    EXPECT_NE(wedge.begin, low) << "the end nearer to the light stays";
    EXPECT_NE(wedge.end, low);
  }
  EXPECT_TRUE(linear_wedges(light, {low, {1, 2, -1}}, end, box).empty());
}

// A direction that is rounding gives no planes; one that is only short does.
TEST(LinearWedge, EdgesNextToNothingAreLeftOut) {
  Light light;
  light.shape = LightShape::sphere;
  light.centre = {0.0, 10.0, 0.0};
  light.radius = 0.5;
  Bounds box;
  box.grow(glm::dvec3(-50.0));
  box.grow(glm::dvec3(50.0));
  const EndPlane end{glm::dvec4(0, 1, 0, 0)};
  const auto edges_left = [&](double length) {
    const std::vector<glm::dvec3> loop{{-1, 2, 1}, {1, 2, 1}, {1, 2, 1.0 - length}, {0, 2, -1}};
    return linear_wedges(light, loop, end, box).size();
  };
  EXPECT_EQ(edges_left(0x1p-50), 3U);
  EXPECT_EQ(edges_left(1e-8), 4U);
}

}  // namespace
}  // namespace wedgesim::functional
