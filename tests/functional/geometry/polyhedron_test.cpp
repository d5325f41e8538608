#include "functional/geometry/polyhedron.h"

#include <gtest/gtest.h>

#include <cmath>
#include <span>

#include "tests/functional/geometry/closed_surface.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

Bounds unit_box() {
  Bounds box;
  box.grow(glm::dvec3(0.0));
  box.grow(glm::dvec3(1.0));
  return box;
}

// That of a call without one, always quadruple precision, and one that ordinary scenes ask for,
// which double serves.
class PolyhedronOfAccuracy : public testing::TestWithParam<double> {};
INSTANTIATE_TEST_SUITE_P(Polyhedron, PolyhedronOfAccuracy, testing::Values(0.0, 1e-10),
                         [](const auto& parameter) {
                           return parameter.param > 0.0 ? "Double" : "Quadruple";
                         });

bool inside(const std::vector<glm::dvec4>& planes, const glm::dvec3& p) {
  for (const glm::dvec4& plane : planes) {
    if (glm::dot(glm::dvec3(plane), p) + plane.w < 0.0) return false;
  }
  return true;
}

TEST(Polyhedron, WithoutPlanesItIsTheBox) {
  const WorldWedge cube = intersect_half_spaces({}, unit_box());
  EXPECT_EQ(cube.faces.size(), 6U);
  EXPECT_EQ(cube.vertices.size(), 8U);
  EXPECT_EQ(cube.planes.size(), 6U);
  EXPECT_NEAR(sums_of(cube).volume6, 6.0, 1e-12);
  EXPECT_EQ(faults_of(cube).unmatched_edges, 0);
}

TEST(Polyhedron, CornerCutOff) {
  const glm::dvec3 n = glm::normalize(glm::dvec3(1.0));
  const std::vector<glm::dvec4> planes{{n, -glm::dot(n, glm::dvec3(0.5, 0.0, 0.0))}};
  const WorldWedge rest = intersect_half_spaces(planes, unit_box());
  EXPECT_EQ(rest.faces.size(), 7U);
  EXPECT_NEAR(sums_of(rest).volume6, 6.0 - 0.125, 1e-12);
  EXPECT_EQ(rest.planes.front(), planes.front()) << "the given planes come first";
}

TEST(Polyhedron, NothingInsideIsNoFaces) {
  const std::vector<glm::dvec4> planes{{1, 0, 0, -0.6}, {-1, 0, 0, 0.4}};
  EXPECT_TRUE(intersect_half_spaces(planes, unit_box()).faces.empty());
  EXPECT_EQ(intersect_half_spaces(planes, unit_box()).planes.size(), 2U);
}

// Is the surface closed, convex and outward, with each edge once in each direction, and its volume
// that of the points inside all planes?
TEST_P(PolyhedronOfAccuracy, RandomPlanes) {
  Random random(95);
  int cut = 0;
  for (int i = 0; i < 3000; ++i) {
    std::vector<glm::dvec4> planes;
    const int count = random.whole(1, 7);
    for (int k = 0; k < count; ++k) {
      const glm::dvec3 n = random.direction();
      const glm::dvec3 p = random.in_box(glm::dvec3(0.0), glm::dvec3(1.0));
      planes.emplace_back(n, 0.3 - glm::dot(n, p));
    }
    const WorldWedge volume = intersect_half_spaces(planes, unit_box(), GetParam());
    if (volume.faces.empty()) continue;
    ++cut;
    const SurfaceFaults faults = faults_of(volume);
    ASSERT_LT(faults.not_planar, 1e-9) << "case " << i;
    ASSERT_LT(faults.not_outside, 1e-9) << "case " << i;
    ASSERT_LT(faults.not_closed, 1e-9) << "case " << i;
    ASSERT_EQ(faults.wrong_way, 0) << "case " << i;
    ASSERT_EQ(faults.unmatched_edges, 0) << "case " << i;
    if (i % 50 != 0) continue;
    int hits = 0;
    constexpr int kSamples = 4000;
    for (int k = 0; k < kSamples; ++k) {
      hits += inside(planes, random.in_box(glm::dvec3(0.0), glm::dvec3(1.0))) ? 1 : 0;
    }
    ASSERT_NEAR(sums_of(volume).volume6 / 6.0, static_cast<double>(hits) / kSamples, 0.04);
  }
  EXPECT_GT(cut, 1500);
}

// Planes through vertices and along faces of the box.
TEST_P(PolyhedronOfAccuracy, PlanesThroughCorners) {
  Random random(96);
  for (int i = 0; i < 3000; ++i) {
    std::vector<glm::dvec4> planes;
    for (int k = 0; k < 4; ++k) {
      const glm::dvec3 n(random.whole(-1, 1), random.whole(-1, 1), random.whole(-1, 1));
      if (n == glm::dvec3(0.0)) continue;
      planes.emplace_back(n, 0.5 * random.whole(-2, 4));
    }
    const WorldWedge volume = intersect_half_spaces(planes, unit_box(), GetParam());
    if (volume.faces.empty()) continue;
    const SurfaceFaults faults = faults_of(volume);
    ASSERT_LT(faults.not_planar, 1e-12) << "case " << i;
    ASSERT_LT(faults.not_outside, 1e-12) << "case " << i;
    ASSERT_LT(faults.not_closed, 1e-12) << "case " << i;
    ASSERT_EQ(faults.wrong_way, 0) << "case " << i;
    ASSERT_EQ(faults.unmatched_edges, 0) << "case " << i;
  }
}

// A sliver about the origin, thinner than the rounding of the box that it is cut from.
TEST(Polyhedron, AThinSliverOfALargeBox) {
  Random random(97);
  const Bounds box{glm::dvec3(-1e10), glm::dvec3(1e10)};
  for (int i = 0; i < 1000; ++i) {
    const glm::dvec3 across = random.direction();
    const glm::dvec3 u = glm::normalize(glm::cross(across, random.direction()));
    const glm::dvec3 v = glm::cross(across, u);
    const std::vector<glm::dvec4> planes{{u, 1.0},  {-u, 1.0},      {v, 1.0},
                                         {-v, 1.0}, {across, 1e-9}, {-across, 1e-9}};
    const WorldWedge sliver = intersect_half_spaces(planes, box);
    ASSERT_EQ(sliver.faces.size(), 6U) << "case " << i;
    for (const WedgeFace& face : sliver.faces) {
      const glm::dvec4& plane = planes[face.plane];
      for (const std::uint32_t c : face.corners) {
        ASSERT_NEAR(glm::dot(glm::dvec3(plane), sliver.vertices[c]) + plane.w, 0.0, 1e-15);
      }
    }
  }
}

// One plane several times, off by rounding or a little more: corners of the first cut are on
// neither side of the others but for that.
TEST(Polyhedron, OnePlaneCutsOnce) {
  Random random(98);
  const Bounds box{glm::dvec3(-16.0), glm::dvec3(16.0)};
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec4 plane(random.direction(), random.uniform(-8.0, 8.0));
    const double off = std::ldexp(1.0, random.whole(-55, -36));
    std::vector<glm::dvec4> planes{plane};
    for (int k = 0; k < 3; ++k) {
      const auto rounded = [&](double value) { return value + off * random.whole(-2, 2); };
      planes.push_back({rounded(plane.x), rounded(plane.y), rounded(plane.z), plane.w});
    }
    const double accuracy = i % 2 == 0 ? 0.0 : 1e-9;
    const double once = sums_of(intersect_half_spaces(std::span(planes).first(1), box)).volume6;
    const WorldWedge rest = intersect_half_spaces(planes, box, accuracy);
    ASSERT_NEAR(sums_of(rest).volume6, once, 1e-5) << "case " << i;
    ASSERT_EQ(faults_of(rest).unmatched_edges, 0) << "case " << i;
  }
}

}  // namespace
}  // namespace wedgesim::functional
