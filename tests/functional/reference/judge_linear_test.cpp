#include "functional/reference/judge_linear.h"

#include <gtest/gtest.h>

#include <cmath>
#include <glm/matrix.hpp>

#include "functional/geometry/extent.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

constexpr double kExact = 1e-50;

double close(const Real& a, const Real& b) { return Real(abs(a - b)).convert_to<double>(); }

// A caster's loop below a light, with the caster on its left as seen from there, and nothing
// decided; volumes end in y = 0.
struct Case {
  Scene scene;
  LinearLoop loop;
  RealPlane end;
  std::vector<SidedPlane> signs{kLinearPlanes};

  explicit Case(std::vector<glm::dvec3> corners) {
    scene.objects.resize(1);
    scene.light.centre = {0.0, 10.0, 0.0};
    for (std::size_t i = 0; i < corners.size(); ++i) {
      loop.vertices.push_back(static_cast<std::uint32_t>(i));
    }
    loop.corners.resize(corners.size());
    scene.objects[0].mesh.positions = std::move(corners);
  }
  RealVector from_light(const glm::dvec3& p) const {
    return RealVector(p) - RealVector(scene.light.centre);
  }
  JudgedLoop judged() {
    end = {{0, 1, 0}, from_light(glm::dvec3(0.0))};
    return {scene, loop, end};
  }
  JudgedPlace place(const glm::dvec3& p) const { return {from_light(p), 100.0}; }
  Real share_at(const glm::dvec3& p, std::size_t edge = 0) {
    return judged().wedge(edge, signs).share(place(p));
  }
};

Case square(double half, double height) {
  return Case(
      {{half, height, half}, {half, height, -half}, {-half, height, -half}, {-half, height, half}});
}

// Are the corners that a frame's data count those that the judge takes?
TEST(JudgeLinear, CornersOfTheLightAreInTheOrderOfTheFrames) {
  Light light;
  light.centre = {1.0, 10.0, -2.0};
  light.half_u = {0.5, 0.125, 0.0};
  light.half_v = {-0.0625, 0.25, 2.0};
  const auto judged = rectangle_corners(light);
  const std::vector<glm::dvec3> corners = light_corners(light);
  ASSERT_EQ(corners.size(), judged.size());
  for (std::size_t i = 0; i < corners.size(); ++i) {
    EXPECT_EQ(light.centre + to_double(judged[i]), corners[i]) << i;
  }
}

// A square under a square. Rays from (-1, 10) and (1, 10) pass the edge (2, 5): the planes are
// 5 (x - 2) + 3 (y - 5) = 0 and 5 (x - 2) + (y - 5) = 0, at (4, 0) 5 of each away. Quads' normals
// are (5, 2, 0) and (0, 2, 5), their sum (5, 4, 5) has products 37 and 29 with the planes'.
TEST(JudgeLinear, SquareUnderARectangleByHand) {
  Case c = square(2.0, 5.0);
  c.scene.light.half_u = {1.0, 0.0, 0.0};
  c.scene.light.half_v = {0.0, 0.0, 1.0};
  EXPECT_LT(close(c.share_at({4.0, 0.0, 0.0}), Real(37) / (37 + 29)), kExact);
  // Both side planes have the same lines across them: nothing changes along the edge.
  EXPECT_LT(close(c.share_at({4.0, 0.0, 3.5}), Real(37) / (37 + 29)), kExact);
  EXPECT_EQ(c.share_at({5.0 + 1e-9, 0.0, 0.0}), 0) << "lit";
  EXPECT_LT(close(c.share_at({5.0, 0.0, 0.0}), 1), kExact);
  EXPECT_LT(close(c.share_at({3.0, 0.0, 0.0}), 0), kExact);
  EXPECT_EQ(c.share_at({3.0 - 1e-9, 0.0, 0.0}), 0) << "in the umbra";
  EXPECT_EQ(c.share_at({4.0, 0.0, 4.0 + 1e-9}), 0) << "the neighbour's";
  EXPECT_EQ(c.share_at({4.1, -1e-9, 0.0}), 0) << "beyond the end";
}

// A square under a sphere. The quad through (3, 6) has the normal (4, 3)/5, so its points are
// (-0.8, 9.4) and (0.8, 10.6); the planes are 3.4 (x - 3) + 3.8 (y - 6) = 0 and
// 4.6 (x - 3) + 2.2 (y - 6) = 0, at (8, 0) 5.8 and 9.8 away; the sum of the quads' normals is
// (4, 6, 4), its products with the planes' 36.4 and 31.6.
TEST(JudgeLinear, SquareUnderASphereByHand) {
  Case c = square(3.0, 6.0);
  c.scene.light.shape = LightShape::sphere;
  c.scene.light.radius = 1.0;
  const Real front = Real(58) / 364;
  const Real back = Real(98) / 316;
  EXPECT_LT(close(c.share_at({8.0, 0.0, 1.0}), back / (front + back)), kExact);
}

// Where the light is not above the middle, each end of an edge has its own intensity and what is
// between goes from one to the other along the edge: a plane of it is worked out from points.
struct Loop {
  std::vector<glm::dvec3> corners;
  Light light;
  glm::dvec3 corner(std::size_t i) const { return corners[i % corners.size()]; }
};

glm::dvec3 normal_of(const glm::dvec3& a, const glm::dvec3& b, const glm::dvec3& c) {
  return glm::normalize(glm::cross(b - a, c - a));
}

// The point of a rectangle for whose ray through the middle of an edge is farthest out, or in.
glm::dvec3 touched(const Loop& loop, std::size_t edge, bool front) {
  const glm::dvec3 begin = loop.corner(edge);
  const glm::dvec3 end = loop.corner(edge + 1);
  const Light& light = loop.light;
  for (const double u : {-1.0, 1.0}) {
    for (const double v : {-1.0, 1.0}) {
      const glm::dvec3 corner = light.centre + u * light.half_u + v * light.half_v;
      const glm::dvec3 into_shadow = normal_of(corner, end, begin);
      bool all = true;
      for (int i = 0; i < 4; ++i) {
        const glm::dvec3 other = light.centre + (i % 2 == 0 ? 1.0 : -1.0) * light.half_u +
                                 (i < 2 ? 1.0 : -1.0) * light.half_v;
        const double side = glm::dot(into_shadow, other - corner);
        all = all && (front ? side <= 1e-9 : side >= -1e-9);
      }
      if (all) return corner;
    }
  }
  ADD_FAILURE() << "no corner touches";
  return light.centre;
}

// Where three planes meet that each go through two corners of the loop and a point, or lie at y =
// 0.
glm::dvec3 meeting(const Loop& loop, std::size_t corner, bool front) {
  const std::size_t before = corner + loop.corners.size() - 1;
  const glm::dvec3 a =
      normal_of(touched(loop, before, front), loop.corner(before), loop.corner(corner));
  const glm::dvec3 b =
      normal_of(touched(loop, corner, front), loop.corner(corner), loop.corner(corner + 1));
  const glm::dvec3 at = loop.corner(corner);
  const glm::dmat3 rows = glm::transpose(glm::dmat3(a, b, glm::dvec3(0.0, 1.0, 0.0)));
  return glm::inverse(rows) * glm::dvec3(glm::dot(a, at), glm::dot(b, at), 0.0);
}

// How far along a direction a plane through three points is.
double way_to(const glm::dvec3& p, const glm::dvec3& direction, const glm::dvec3& a,
              const glm::dvec3& b, const glm::dvec3& c) {
  const glm::dvec3 n = normal_of(a, b, c);
  return std::abs(glm::dot(n, a - p) / glm::dot(n, direction));
}

double share_by_points(const Loop& loop, std::size_t edge, const glm::dvec3& p) {
  const glm::dvec3 begin = loop.corner(edge);
  const glm::dvec3 end = loop.corner(edge + 1);
  const std::size_t n = loop.corners.size();
  const auto quad = [&](std::size_t i) {
    return normal_of(loop.light.centre, loop.corner(i + 1), loop.corner(i));
  };
  std::array<double, 2> seen{};
  std::array<double, 2> to_side{};
  for (std::size_t k = 0; k < 2; ++k) {
    const glm::dvec3 at = loop.corner(edge + k);
    const std::array<glm::dvec3, 3> side{at, meeting(loop, edge + k, true),
                                         meeting(loop, edge + k, false)};
    const glm::dvec3 normal = normal_of(side[0], side[1], side[2]);
    const glm::dvec3 middle = quad((edge + k + n - 1) % n) + quad((edge + k) % n);
    const glm::dvec3 across = glm::normalize(middle - glm::dot(middle, normal) * normal);
    const double front = way_to(p, across, touched(loop, edge, true), begin, end);
    const double back = way_to(p, across, touched(loop, edge, false), begin, end);
    seen[k] = back / (front + back);
    to_side[k] = way_to(p, glm::normalize(end - begin), side[0], side[1], side[2]);
  }
  return (to_side[1] * seen[0] + to_side[0] * seen[1]) / (to_side[0] + to_side[1]);
}

TEST(JudgeLinear, AgreesWithPointsAndRays) {
  Random random(311);
  int inside = 0;
  for (int i = 0; i < 200; ++i) {
    const auto near = [&](double x, double z) {
      return glm::dvec3(x, 5.0, z) + random.in_box(glm::dvec3(-0.7), glm::dvec3(0.7));
    };
    Case c({near(2.0, 2.0), near(2.0, -2.0), near(-2.0, -2.0), near(-2.0, 2.0)});
    c.scene.light.centre = random.in_box({-2.0, 9.0, -2.0}, {2.0, 12.0, 2.0});
    const glm::dvec3 axis =
        glm::normalize(random.in_box(glm::dvec3(-0.2, 1.0, -0.2), {0.2, 1.0, 0.2}));
    const glm::dvec3 u = glm::normalize(glm::cross(axis, random.direction()));
    c.scene.light.half_u = random.uniform(0.1, 0.8) * u;
    c.scene.light.half_v = random.uniform(0.1, 0.8) * glm::cross(u, axis);
    const Loop loop{c.scene.objects[0].mesh.positions, c.scene.light};
    const std::size_t edge = i % 4U;
    const JudgedLoop judged = c.judged();
    const JudgedWedge wedge = judged.wedge(edge, c.signs);
    // Between the four points where the wedge meets the floor.
    std::array<double, 4> weights{};
    double sum = 0.0;
    for (double& weight : weights) sum += weight = random.uniform(0.1, 1.0);
    glm::dvec3 p(0.0);
    for (std::size_t k = 0; k < 4; ++k) {
      p += weights[k] / sum * meeting(loop, edge + k / 2, k % 2 == 0);
    }
    p = glm::mix(p, loop.corner(edge), 0.01);
    const Real share = wedge.share(c.place(p));
    if (share == 0) continue;  // of a twisted one the middle may be outside
    ++inside;
    ASSERT_NEAR(share.convert_to<double>(), share_by_points(loop, edge, p), 1e-9) << "case " << i;
  }
  EXPECT_GT(inside, 150);
}

// An edge whose line meets the very border of the light: one plane is its front and its back and
// so touches both corners there.
TEST(JudgeLinear, ALineThroughTheBorderOfTheLight) {
  Case c({{1.0, 5.0, -0.5}, {1.0, 2.0, -0.5}, {0.0, 5.0, 2.0}});
  c.scene.light.half_u = {0.0, 0.0, 1.0};
  c.scene.light.half_v = {1.0, 0.0, 0.0};
  const auto planes = c.judged().wedge(0, c.signs).planes();
  EXPECT_EQ(to_double(planes[0].normal()), to_double(planes[1].normal()));
  for (const double x : {0.0, 1.0, 3.0}) {
    EXPECT_LT(close(abs(planes[0].value(c.place({x, 0.0, 7.0}))), std::abs(x - 1.0)), kExact);
  }
}

// Do neighbours, whose signs differ, have one plane between them, bit for bit?
TEST(JudgeLinear, NeighboursShareTheirSidePlane) {
  Case c = square(2.0, 5.0);
  c.scene.light.half_u = {1.0, 0.0, 0.25};
  c.scene.light.half_v = {-0.25, 0.0, 1.0};
  std::vector<SidedPlane> others = c.signs;
  for (SidedPlane& plane : others) plane.minus = true;
  const JudgedLoop judged = c.judged();
  const JudgedPlane right = judged.wedge(0, c.signs).planes()[3];
  const JudgedPlane left = judged.wedge(1, others).planes()[2];
  const glm::dvec3 ends[]{{2.0, 5.0, -2.0}, {1.0, 5.0, -1.0}};
  for (const glm::dvec3& p : ends) {
    EXPECT_EQ(right.value(c.place(p)), left.value(c.place(p)));
    EXPECT_NE(right.inside(c.place(p)), left.inside(c.place(p))) << "ties included";
  }
  EXPECT_EQ(right.value(c.place(ends[0])), 0) << "the corner itself";
}

// Where planes meet too far aside, the ray through the corner, from the middle of what their planes
// touch, is in the side plane, and the front face is bent there.
TEST(JudgeLinear, RaysInThePlaceOfLines) {
  Case c = square(2.0, 5.0);
  c.scene.light.half_u = {1.0, 0.0, 0.0};
  c.scene.light.half_v = {0.0, 0.0, 1.0};
  c.loop.corners[1].by_ray = {true, true};
  // Edge 0's front plane touches the side x = -1, edge 1's z = 1: of the ends of those sides the
  // trace says which.
  c.loop.corners[0].touched = {0, 2};  // (-1, -1) and (1, 1)
  c.loop.corners[1].touched = {2, 0};  // (1, 1) and (-1, -1)
  const JudgedLoop judged = c.judged();
  // Both rays come from the light's centre: the corner (2, 5, -2) has (4, 0, -4) below it.
  const glm::dvec3 far(4.0, 0.0, -4.0);
  UmbraSource source{UmbraPlane::far_half, {0, 0, 1, 0, 0}};
  const glm::dvec3 others[]{{2.0, 5.0, -2.0}, {5.0, 0.0, 5.0}};
  const JudgedPlane half = judged.umbra_plane(source, false);
  EXPECT_LT(close(half.value(c.place(far)), 0), kExact);
  for (const glm::dvec3& p : others) EXPECT_LT(close(half.value(c.place(p)), 0), kExact);
  EXPECT_TRUE(half.inside(c.place({0.0, 0.0, 0.0})));
  EXPECT_FALSE(half.inside(c.place({9.0, 0.0, 0.0})));
  source.turned = true;
  EXPECT_FALSE(judged.umbra_plane(source, false).inside(c.place({0.0, 0.0, 0.0})));
  source = {UmbraPlane::near_half, {0, 0, 1, 0, 0}};
  const JudgedPlane near = judged.umbra_plane(source, false);
  EXPECT_LT(close(near.value(c.place({5.0, 0.0, 5.0})), 0), kExact);
  EXPECT_LT(close(near.value(c.place({2.0, 5.0, 2.0})), 0), kExact);
  EXPECT_TRUE(near.inside(c.place({0.0, 0.0, 0.0})));
  source.plane = UmbraPlane::front;
  EXPECT_LT(close(judged.umbra_plane(source, false).value(c.place({5.0, 0.0, 1.0})), 0), kExact);
}

}  // namespace
}  // namespace wedgesim::functional
