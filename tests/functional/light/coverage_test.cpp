#include "functional/light/coverage.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/matrix.hpp>
#include <iomanip>
#include <numbers>

#include "tests/functional/light/exact_area.h"
#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

using Wide3 = glm::tvec3<long double>;

// The part of a polygon of light points, x·u + y·v about the light's centre, that the infinite
// shadow quad {s·e : e on the edge, s ≥ 1} hides from a point. A light point is hidden iff the
// segment to it meets the quad: half-planes in x and y.
LightPolygon hidden_part(LightPolygon light, const Wide3& u, const Wide3& v, const Wide3& point,
                         const Wide3& begin, const Wide3& end) {
  const Wide3 n = glm::cross(begin, end);
  const long double nn = glm::dot(n, n);
  const long double at_point = glm::dot(n, point);
  if (nn == 0.0L || at_point == 0.0L) return {};
  // q = α·begin + β·end on the quad's plane; α and β as linear functions of space.
  const Wide3 alpha = glm::cross(end, n) / nn;
  const Wide3 beta = glm::cross(n, begin) / nn;
  // Keeps light points X with f(X) ≥ 0, f affine.
  const auto keep = [&](const auto& f) {
    const long double at_zero = f(Wide3(0.0L));
    light = clip_half_plane(light, f(u) - at_zero, f(v) - at_zero, at_zero);
  };
  const long double sign = at_point > 0.0L ? 1.0L : -1.0L;
  keep([&](const Wide3& x) { return -sign * glm::dot(n, x); });  // the plane is crossed
  // q = point + t (X − point), t = at_point / (at_point − n·X), whose denominator has `sign`.
  const auto on_quad = [&](const Wide3& function, const Wide3& x) {
    return sign * (at_point * glm::dot(function, x) - glm::dot(n, x) * glm::dot(function, point));
  };
  keep([&](const Wide3& x) { return on_quad(alpha, x); });
  keep([&](const Wide3& x) { return on_quad(beta, x); });
  keep([&](const Wide3& x) {
    return on_quad(alpha + beta, x) - sign * (at_point - glm::dot(n, x));
  });
  return light;
}

double exact_rectangle(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end) {
  const LightPolygon part = hidden_part(square_of(1.0L), Wide3(1, 0, 0), Wide3(0, 1, 0),
                                        Wide3(point), Wide3(begin), Wide3(end));
  return static_cast<double>(std::abs(area_of(part)) / 4.0L);
}

double exact_sphere(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end) {
  const Wide3 p(point);
  const long double distance = glm::length(p);
  const Wide3 axis = p / distance;
  const long double radius = distance / std::sqrt(distance * distance - 1.0L);
  const Wide3 helper = std::abs(axis.z) < 0.7L ? Wide3(0, 0, 1) : Wide3(1, 0, 0);
  const Wide3 u = glm::normalize(glm::cross(axis, helper));
  const Wide3 v = glm::cross(axis, u);
  const LightPolygon part =
      hidden_part(square_of(1.25L), radius * u, radius * v, p, Wide3(begin), Wide3(end));
  return static_cast<double>(std::abs(area_in_disc(part)) / std::numbers::pi_v<long double>);
}

// The same by the definition alone: is the segment from the point to a light point cut by the
// quad, as a triangle that reaches far?
double sampled_rectangle(const glm::dvec3& point, const glm::dvec3& begin, const glm::dvec3& end,
                         int side) {
  int hidden = 0;
  for (int i = 0; i < side * side; ++i) {
    const glm::dvec3 x((2.0 * (i % side) + 1.0) / side - 1.0, (2.0 * (i / side) + 1.0) / side - 1.0,
                       0.0);
    const glm::dvec3 n = glm::cross(begin, end);
    const double from = glm::dot(n, point);
    const double to = glm::dot(n, x);
    if ((from > 0.0) == (to > 0.0)) continue;
    const glm::dvec3 q = point + from / (from - to) * (x - point);
    const double alpha = glm::dot(glm::cross(q, end), n) / glm::dot(n, n);
    const double beta = glm::dot(glm::cross(begin, q), n) / glm::dot(n, n);
    if (alpha >= 0.0 && beta >= 0.0 && alpha + beta >= 1.0) ++hidden;
  }
  return static_cast<double>(hidden) / (side * side);
}

struct Case {
  glm::dvec3 point, begin, end;
};

std::ostream& operator<<(std::ostream& out, const Case& c) {
  out << std::setprecision(17);
  for (const glm::dvec3& p : {c.point, c.begin, c.end}) {
    out << '(' << p.x << ", " << p.y << ", " << p.z << ") ";
  }
  return out;
}

// An end of an edge in front of the light, before the light as the point sees it, or anywhere.
glm::dvec3 random_end(Random& random, const glm::dvec3& point) {
  for (;;) {
    glm::dvec3 e = random.in_box(glm::dvec3(-6.0, -6.0, 0.05), glm::dvec3(6.0, 6.0, 14.0));
    if (random.chance(0.7)) {
      const glm::dvec3 x(random.uniform(-2.0, 2.0), random.uniform(-2.0, 2.0), 0.0);
      e = point + random.uniform(0.01, 0.99) * (x - point);
    }
    // On the point's side of the light: what is beyond it casts its shadow elsewhere.
    if (e.z > 0.05 && glm::length(e) > 1.05 && glm::dot(e, point) > 0.0) return e;
  }
}

Case random_case(Random& random) {
  Case c;
  do {
    c.point = random.in_box(glm::dvec3(-6.0, -6.0, 0.5), glm::dvec3(6.0, 6.0, 12.0));
    c.begin = random_end(random, c.point);
    c.end = random_end(random, c.point);
    // The edge outside the sphere.
    const glm::dvec3 way = c.end - c.begin;
    const double t = std::clamp(-glm::dot(c.begin, way) / glm::dot(way, way), 0.0, 1.0);
    if (glm::length(c.begin + t * way) < 1.02) c.point = glm::dvec3(0.0);
  } while (glm::length(c.point) < 1.02);
  return c;
}

TEST(ExactArea, DiscAgreesWithAPolygonOfManySides) {
  Random random(51);
  for (int i = 0; i < 20; ++i) {
    LightPolygon polygon;
    for (int k = 0; k < 5; ++k) {
      const long double angle = 2.0L * std::numbers::pi_v<long double> * k / 5.0L;
      const long double radius = random.uniform(0.3, 2.5);
      polygon.push_back({radius * std::cos(angle) + 0.2L, radius * std::sin(angle)});
    }
    LightPolygon clipped = polygon;
    constexpr int kSides = 1024;
    for (int k = 0; k < kSides; ++k) {
      const long double angle = 2.0L * std::numbers::pi_v<long double> * k / kSides;
      clipped = clip_half_plane(clipped, -std::cos(angle), -std::sin(angle), 1.0L);
    }
    EXPECT_NEAR(static_cast<double>(area_of(clipped)), static_cast<double>(area_in_disc(polygon)),
                5e-5);
  }
}

// Is the coverage of a rectangle the exact area, edges behind the point included?
TEST(Coverage, RectangleIsTheExactArea) {
  Random random(52);
  double worst = 0.0;
  int covered = 0;
  int partly_behind = 0;
  for (int i = 0; i < 200000; ++i) {
    const Case c = random_case(random);
    const double expected = exact_rectangle(c.point, c.begin, c.end);
    const double found = rectangle_coverage(c.point, c.begin, c.end);
    worst = std::max(worst, std::abs(found - expected));
    ASSERT_NEAR(found, expected, 1e-11) << "case " << i << ": " << c;
    if (expected > 1e-6) {
      ++covered;
      if ((c.begin.z > c.point.z) != (c.end.z > c.point.z)) ++partly_behind;
    }
  }
  std::cout << "largest error " << worst << '\n';
  EXPECT_GT(covered, 50000);
  EXPECT_GT(partly_behind, 2000);
}

TEST(Coverage, SphereIsTheExactArea) {
  Random random(53);
  double worst = 0.0;
  int covered = 0;
  int partly_behind = 0;
  for (int i = 0; i < 200000; ++i) {
    const Case c = random_case(random);
    const double expected = exact_sphere(c.point, c.begin, c.end);
    const double found = sphere_coverage(c.point, c.begin, c.end);
    worst = std::max(worst, std::abs(found - expected));
    ASSERT_NEAR(found, expected, 1e-11) << "case " << i << ": " << c;
    if (expected > 1e-6) {
      ++covered;
      const double front_begin = glm::dot(c.begin - c.point, -c.point);
      const double front_end = glm::dot(c.end - c.point, -c.point);
      if ((front_begin > 0.0) != (front_end > 0.0)) ++partly_behind;
    }
  }
  std::cout << "largest error " << worst << '\n';
  EXPECT_GT(covered, 30000);
  EXPECT_GT(partly_behind, 1000);
}

// Does the exact area agree with the definition, by samples? (The judge judged.)
TEST(Coverage, RectangleAgreesWithSamples) {
  Random random(54);
  for (int i = 0; i < 300; ++i) {
    const Case c = random_case(random);
    ASSERT_NEAR(rectangle_coverage(c.point, c.begin, c.end),
                sampled_rectangle(c.point, c.begin, c.end, 256), 0.004)
        << "case " << i;
  }
}

// Points close to an edge, as where a caster stands on a receiver.
TEST(Coverage, NearContact) {
  Random random(55);
  for (const double way : {1e-2, 1e-4, 1e-6}) {
    for (int i = 0; i < 20000; ++i) {
      Case c = random_case(random);
      c.begin = c.point + way * random.uniform(0.1, 1.0) * random.direction();
      c.end = c.point + random.uniform(0.1, way < 1e-3 ? 0.2 : 1.0) * random.direction();
      if (glm::dot(c.begin, c.point) < 0.0 || glm::dot(c.end, c.point) < 0.0) continue;
      if (glm::length(c.begin) < 1.01 || c.begin.z < 0.05 || c.end.z < 0.05) continue;
      if (glm::length(c.end) < 1.01 || glm::length(c.begin + c.end) < 2.1) continue;
      // Rounding of the ends' positions alone moves the projection by about 1e-15 / way.
      const double bound = 1e-13 / way + 1e-11;
      ASSERT_NEAR(rectangle_coverage(c.point, c.begin, c.end),
                  exact_rectangle(c.point, c.begin, c.end), bound)
          << "case " << i << ", way " << way;
      ASSERT_NEAR(sphere_coverage(c.point, c.begin, c.end), exact_sphere(c.point, c.begin, c.end),
                  bound)
          << "case " << i << ", way " << way;
    }
  }
}

// The end of a long edge next to the centre decides its angle there: cut off outside the light, the
// edge covers as much.
TEST(Coverage, EndsNextToTheCentreOfLongEdges) {
  Random random(57);
  for (int i = 0; i < 20000; ++i) {
    const glm::dvec3 point(0.0, 0.0, random.uniform(4.0, 8.0));
    const double off = std::ldexp(random.uniform(0.5, 1.0), -random.whole(0, 30));
    const glm::dvec3 end =
        glm::dvec3(0.0, 0.0, 1.0) + off * glm::dvec3(glm::normalize(glm::dvec2(1.0, 0.3)), 0.0);
    const double turn = random.uniform(0.0, 6.3);
    const glm::dvec3 way(std::cos(turn), std::sin(turn), 0.0);
    const glm::dvec3 begin = end + std::ldexp(1.0, random.whole(5, 20)) * way;
    const glm::dvec3 cut = end + 4.0 * way;
    const glm::dvec3 up(0.0, 0.0, 1.0);  // clear of the sphere
    ASSERT_NEAR(rectangle_coverage(point, begin, end), rectangle_coverage(point, cut, end), 1e-9)
        << "case " << i;
    ASSERT_NEAR(sphere_coverage(point, begin + up, end + up),
                sphere_coverage(point, cut + up, end + up), 1e-9)
        << "case " << i;
  }
}

// An edge seen along a ray from the light's centre hides nothing, whatever rounding says about the
// corner that the ray passes through.
TEST(Coverage, RadialEdgesHideNothing) {
  Random random(56);
  const std::array<glm::dvec2, 8> directions{
      {{1, 1}, {-1, 1}, {-1, -1}, {1, -1}, {1, 0}, {0, 1}, {-1, 0}, {0, -1}}};
  for (int i = 0; i < 100000; ++i) {
    const glm::dvec3 point = random.in_box(glm::dvec3(-3.0, -3.0, 4.0), glm::dvec3(3.0, 3.0, 12.0));
    const glm::dvec2 way = directions[static_cast<std::size_t>(random.whole(0, 7))];
    const auto end_at = [&](double reach) {
      const glm::dvec3 x(reach * way, 0.0);
      return point + random.uniform(0.1, 0.7) * (x - point);
    };
    const glm::dvec3 begin = end_at(random.uniform(0.01, 0.98));
    const glm::dvec3 end = end_at(random.uniform(0.01, 2.0));
    ASSERT_LT(rectangle_coverage(point, begin, end), 1e-12)
        << "case " << i << ", way " << way.x << ' ' << way.y;
    ASSERT_LT(sphere_coverage(point, begin, end), 1e-7) << "case " << i;
  }
}

TEST(Coverage, IsSymmetricAndAtMostOneHalf) {
  Random random(57);
  for (int i = 0; i < 20000; ++i) {
    const Case c = random_case(random);
    for (const LightShape shape : {LightShape::rectangle, LightShape::sphere}) {
      const double forth = coverage(shape, c.point, c.begin, c.end);
      const double back = coverage(shape, c.point, c.end, c.begin);
      ASSERT_NEAR(forth, back, 1e-11);
      ASSERT_GE(forth, 0.0);
      ASSERT_LE(forth, 0.5);
    }
    ASSERT_EQ(coverage(LightShape::point, c.point, c.begin, c.end), 0.0);
  }
}

// An edge that crosses all of the light through its centre hides half of it.
TEST(Coverage, HalfTheLight) {
  const glm::dvec3 point(0.0, 0.0, 8.0);
  const glm::dvec3 begin(-5.0, 0.5e-12, 4.0);
  const glm::dvec3 end(5.0, 0.5e-12, 4.0);
  EXPECT_NEAR(rectangle_coverage(point, begin, end), 0.5, 1e-11);
  EXPECT_NEAR(sphere_coverage(point, begin, end), 0.5, 1e-11);
  EXPECT_EQ(rectangle_coverage(point, begin + glm::dvec3(0, 9, 0), end + glm::dvec3(0, 9, 0)), 0.0);
  EXPECT_EQ(sphere_coverage(glm::dvec3(0.0, 0.0, 0.5), begin, end), 0.0) << "inside the sphere";
  EXPECT_EQ(rectangle_coverage(glm::dvec3(0.0, 0.0, -1.0), begin, end), 0.0) << "behind the light";
}

// Does light space have the light's corners at ±1 and its normal third?
TEST(LightFromWorld, MapsTheLightToItsUnit) {
  Light light;
  light.centre = {1.0, 2.0, 3.0};
  light.half_u = {0.0, 0.0, 2.0};
  light.half_v = {0.5, 0.0, 0.0};
  const glm::dmat4 rectangle = light_from_world(light);
  const auto map = [](const glm::dmat4& m, const glm::dvec3& p) {
    return glm::dvec3(m * glm::dvec4(p, 1.0));
  };
  const auto near = [](const glm::dvec3& a, const glm::dvec3& b) {
    return glm::length(a - b) < 1e-12;
  };
  EXPECT_TRUE(near(map(rectangle, light.centre), glm::dvec3(0.0)));
  EXPECT_TRUE(near(map(rectangle, light.centre + light.half_u), glm::dvec3(1, 0, 0)));
  EXPECT_TRUE(near(map(rectangle, light.centre + light.half_v), glm::dvec3(0, 1, 0)));
  EXPECT_TRUE(near(map(rectangle, light.centre + glm::dvec3(0, 3, 0)), glm::dvec3(0, 0, 3)));
  light.shape = LightShape::sphere;
  light.radius = 0.25;
  const glm::dmat4 sphere = light_from_world(light);
  EXPECT_TRUE(near(map(sphere, light.centre + glm::dvec3(0.25, 0, 0)), glm::dvec3(1, 0, 0)));
  EXPECT_EQ(glm::determinant(sphere), 64.0);
  light.shape = LightShape::point;
  EXPECT_TRUE(near(map(light_from_world(light), glm::dvec3(0.0)), -light.centre));
}

}  // namespace
}  // namespace wedgesim::functional
