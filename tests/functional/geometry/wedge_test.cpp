#include "functional/geometry/wedge.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <glm/common.hpp>

#include "functional/light/coverage.h"
#include "tests/functional/geometry/closed_surface.h"
#include "tests/functional/geometry/penumbra.h"

namespace wedgesim::functional {
namespace {

// Sides between rays a millionth apart have no plane of their own (kLeastSpread in wedge.cpp).
constexpr double kSlack = 3e-5;

class WedgeOfLight : public testing::TestWithParam<LightShape> {};

INSTANTIATE_TEST_SUITE_P(Lights, WedgeOfLight,
                         testing::Values(LightShape::rectangle, LightShape::sphere),
                         [](const auto& parameter) {
                           return parameter.param == LightShape::rectangle ? "rectangle" : "sphere";
                         });

WorldWedge wedge_of(const EdgeCase& edge) {
  return coverage_wedge(edge.light, edge.begin, edge.end, edge.end_plane);
}

// The least value of a point in the planes that decide.
double depth_in(const WorldWedge& wedge, const glm::dvec3& p) {
  double least = 1e300;
  for (std::size_t i = 0; i < std::min(wedge.planes.size(), kMaxPlanes); ++i) {
    least = std::min(least, glm::dot(glm::dvec3(wedge.planes[i]), p) + wedge.planes[i].w);
  }
  return least;
}

double covered(const EdgeCase& edge, const glm::dvec3& p) {
  const glm::dmat4 to_light = light_from_world(edge.light);
  const auto map = [&](const glm::dvec3& q) { return glm::dvec3(to_light * glm::dvec4(q, 1.0)); };
  return coverage(edge.light.shape, map(p), map(edge.begin), map(edge.end));
}

// Conservative: does it hold every point from which the edge covers a part of the light?
TEST_P(WedgeOfLight, HoldsThePenumbra) {
  Random random(101);
  for (int i = 0; i < 20000; ++i) {
    const EdgeCase edge = random_edge(random, GetParam());
    const WorldWedge wedge = wedge_of(edge);
    if (wedge.planes.empty()) continue;
    for (int k = 0; k < 30; ++k) {
      const glm::dvec3 p = penumbra_point(random, edge);
      const double size = glm::distance(p, edge.light.centre);
      ASSERT_GT(depth_in(wedge, p), -1e-9 * size) << "case " << i << ": " << edge;
    }
  }
}

// Does no point outside see the edge cover anything?
TEST_P(WedgeOfLight, NothingIsCoveredOutside) {
  Random random(102);
  int outside = 0;
  int inside = 0;
  for (int i = 0; i < 5000; ++i) {
    const EdgeCase edge = random_edge(random, GetParam());
    const WorldWedge wedge = wedge_of(edge);
    if (wedge.planes.empty()) continue;
    for (int k = 0; k < 40; ++k) {
      // Near the wedge more often than far away.
      glm::dvec3 p = random.in_box(kReceiversLow, kReceiversHigh);
      if (k % 2 == 0) {
        p = penumbra_point(random, edge) + random.uniform(0.0, 1.0) * random.direction();
      }
      if (glm::clamp(p, kReceiversLow, kReceiversHigh) != p) continue;
      if (depth_in(wedge, p) > -1e-9) {
        ++inside;
        continue;
      }
      ++outside;
      ASSERT_LT(covered(edge, p), 1e-12) << "case " << i << ": " << edge;
    }
  }
  EXPECT_GT(outside, 20000);
  EXPECT_GT(inside, 5000);
}

// Are the faces planar, outward, closed, and few enough planes all of them?
TEST_P(WedgeOfLight, FacesCloseTheVolume) {
  Random random(103);
  std::array<int, 16> plane_counts{};
  int exact = 0;
  for (int i = 0; i < 20000; ++i) {
    const EdgeCase edge = random_edge(random, GetParam());
    const WorldWedge wedge = wedge_of(edge);
    if (wedge.planes.empty()) continue;
    ++plane_counts.at(wedge.planes.size());
    ASSERT_LE(wedge.planes.size(), kMaxPlanes) << "case " << i << ": " << edge;
    const SurfaceFaults faults = faults_of(wedge);
    ASSERT_LT(faults.not_planar, kSlack) << "case " << i << ": " << edge;
    ASSERT_LT(faults.not_outside, kSlack) << "case " << i << ": " << edge;
    if (faults.not_planar < 1e-9 && faults.not_outside < 1e-9) ++exact;
    ASSERT_LT(faults.not_closed, 1e-9) << "case " << i << ": " << edge;
    ASSERT_EQ(faults.wrong_way, 0) << "case " << i << ": " << edge;
    ASSERT_GT(sums_of(wedge).volume6, 0.0) << "case " << i << ": " << edge;
    ASSERT_EQ(faults.unmatched_edges, 0) << "case " << i << ": " << edge;
  }
  EXPECT_GT(exact, 15000);
  std::cout << "wedges by number of planes:";
  for (std::size_t n = 4; n < 12; ++n) std::cout << ' ' << n << ": " << plane_counts[n];
  std::cout << '\n';
}

// An edge so short that a sphere sees it under less than a millionth: are faces and planes one
// volume all the same, as far as the edge's length tells?
TEST(Wedge, FacesOfShortEdgesReachTheirPlanes) {
  Random random(106);
  for (const double length : {1e-4, 1e-6, 1e-8}) {
    double worst = 0.0;
    for (int i = 0; i < 300; ++i) {
      EdgeCase edge;
      edge.light = random_light(random, LightShape::sphere);
      edge.begin = random.in_box({-3.0, 1.0, -3.0}, {3.0, 5.0, 3.0});
      edge.end = edge.begin + length * random.direction();
      choose_end(edge);
      const WorldWedge wedge = wedge_of(edge);
      ASSERT_FALSE(wedge.planes.empty());
      worst = std::max(worst, faults_of(wedge).not_planar);
    }
    std::cout << "length " << length << ": " << worst << '\n';
    EXPECT_LT(worst, 0.01 * length);
  }
}

// How much of the wedge is penumbra? For a rectangle all of it, for a sphere most.
TEST_P(WedgeOfLight, IsTight) {
  Random random(104);
  double sum = 0.0;
  double least = 1.0;
  int wedges = 0;
  for (int i = 0; i < 300; ++i) {
    EdgeCase edge;
    edge.light = random_light(random, GetParam());
    edge.begin = random.in_box({-3.0, 1.0, -3.0}, {3.0, 5.0, 3.0});
    edge.end = edge.begin + random.uniform(0.5, 2.0) * random.direction();
    choose_end(edge);
    const WorldWedge wedge = wedge_of(edge);
    Bounds bounds;
    for (const glm::dvec3& v : wedge.vertices) bounds.grow(v);
    int held = 0;
    int seen = 0;
    for (int k = 0; k < 20000; ++k) {
      const glm::dvec3 p = random.in_box(bounds.low, bounds.high);
      if (depth_in(wedge, p) < 0.0) continue;
      ++held;
      if (covered(edge, p) > 0.0) ++seen;
    }
    if (held < 200) continue;
    const double share = static_cast<double>(seen) / held;
    sum += share;
    least = std::min(least, share);
    ++wedges;
  }
  std::cout << "penumbra's share of its wedge: mean " << sum / wedges << ", least " << least
            << " of " << wedges << '\n';
  EXPECT_GT(wedges, 200);
  EXPECT_GT(sum / wedges, GetParam() == LightShape::rectangle ? 0.95 : 0.7);
}

// The quad's plane: through the light's centre and the edge, positive on the shadow's side, which
// is left of the directed edge as seen from the light.
double area(std::span<const glm::dvec3> polygon) {
  glm::dvec3 sum(0.0);
  for (std::size_t i = 1; i + 1 < polygon.size(); ++i) {
    sum += glm::cross(polygon[i] - polygon[0], polygon[i + 1] - polygon[0]);
  }
  return 0.5 * glm::length(sum);
}

// Paper IV, 4.4: do the faces of both halves, each on its side of the shadow quad's plane, make up
// those of the wedge?
TEST_P(WedgeOfLight, HalvesMakeUpTheWedge) {
  Random random(104);
  int split = 0;
  for (int i = 0; i < 3000; ++i) {
    const EdgeCase edge = random_edge(random, GetParam());
    const WorldWedge wedge = wedge_of(edge);
    const glm::dvec4 plane = quad_plane(edge.light.centre, edge.begin, edge.end);
    double whole = 0.0;
    for (const WedgeFace& face : wedge.faces) {
      std::vector<glm::dvec3> corners;
      for (const std::uint32_t c : face.corners) corners.push_back(wedge.vertices[c]);
      whole += area(corners);
    }
    double halves = 0.0;
    for (const double side : {1.0, -1.0}) {
      const auto faces = faces_inside(wedge, side * plane);
      split += faces.empty() ? 0 : 1;
      for (const auto& face : faces) {
        halves += area(face);
        for (const glm::dvec3& p : face) {
          const double size = glm::distance(p, edge.light.centre);
          const double depth = glm::dot(side * plane, glm::dvec4(p, 1.0));
          ASSERT_GT(depth, -1e-9 * size * glm::length(glm::dvec3(plane))) << "case " << i;
        }
      }
    }
    ASSERT_NEAR(halves, whole, 1e-9 * whole) << "case " << i << ": " << edge;
  }
  EXPECT_GT(split, 5000) << "wedges have two halves";
}

TEST(Wedge, QuadPlaneFacesTheShadow) {
  const glm::dvec4 plane = quad_plane({0, 10, 0}, {1, 0, 1}, {1, 0, -1});
  // Seen from above, z down the page: the edge goes up, the caster is left of it at smaller x.
  const auto value = [&](const glm::dvec3& p) { return glm::dot(glm::dvec3(plane), p) + plane.w; };
  EXPECT_GT(value({0.0, -1.0, 0.0}), 0.0);
  EXPECT_LT(value({2.0, -1.0, 0.0}), 0.0);
  EXPECT_NEAR(value({0, 10, 0}), 0.0, 1e-12);
  EXPECT_NEAR(value({1, 0, 1}), 0.0, 1e-12);
  EXPECT_NEAR(value({1, 0, -1}), 0.0, 1e-12);
}

// An edge in one line with the centre of a small sphere, one end 2^28 times as far: nothing is left
// of the difference of its ends.
TEST(Wedge, LongEdgesTowardsTheLightReachTheirEnd) {
  Random random(205);
  Light light;
  light.shape = LightShape::sphere;
  light.radius = 0x1p-28;
  const EndPlane end_plane{{0.0, 1.0, 0.0, 0x1.1p28}};
  for (int i = 0; i < 200; ++i) {
    const glm::dvec3 near_end(random.uniform(-1.0, 1.0), -1.0, random.uniform(-1.0, 1.0));
    const WorldWedge wedge = coverage_wedge(light, 0x1p28 * near_end, near_end, end_plane);
    ASSERT_FALSE(wedge.vertices.empty()) << "case " << i;
    for (const glm::dvec3& vertex : wedge.vertices) {
      // A light that small widens the edge by less than its own length.
      ASSERT_LT(glm::distance(vertex, -vertex.y * near_end), 0x1p20) << "case " << i;
    }
  }
}

TEST(Wedge, NoLightNoEdgeNoWedge) {
  EdgeCase edge;
  edge.light.centre = {0.0, 10.0, 0.0};
  edge.light.half_u = {1.0, 0.0, 0.0};
  edge.light.half_v = {0.0, 0.0, 1.0};
  edge.begin = {0.0, 2.0, 0.0};
  edge.end = {1.0, 2.0, 0.0};
  choose_end(edge);
  EXPECT_EQ(wedge_of(edge).planes.size(), 5U) << "level and along the light: four sides";
  edge.end = {1.0, 3.0, 0.5};
  EXPECT_EQ(wedge_of(edge).planes.size(), 7U) << "six sides (Paper IV, 4.1) and the bottom";
  edge.end = edge.begin;
  EXPECT_EQ(wedge_of(edge).planes.size(), 5U) << "a pyramid behind one point";
}

}  // namespace
}  // namespace wedgesim::functional
