#include "functional/raster/light_map.h"

#include <gtest/gtest.h>
#include <tbb/global_control.h>

#include <cmath>
#include <glm/geometric.hpp>
#include <optional>

#include "tests/functional/random.h"

namespace wedgesim::functional {
namespace {

using Triangle = std::array<glm::dvec3, 3>;
constexpr int kSize = 96;
const glm::dvec3 kCentre(1.0, 5.0, -2.0);
const glm::dvec3 kAxis(0.3, -1.0, 0.2);
constexpr double kNear = 0.5;

// Some of them cross the near plane.
std::vector<Triangle> random_triangles(Random& random, int count) {
  std::vector<Triangle> triangles;
  for (int i = 0; i < count; ++i) {
    const glm::dvec3 middle = kCentre + random.uniform(0.2, 8.0) * kAxis +
                              random.in_box(glm::dvec3(-3.0), glm::dvec3(3.0));
    Triangle triangle;
    for (glm::dvec3& p : triangle) p = middle + random.uniform(0.3, 2.5) * random.direction();
    triangles.push_back(triangle);
  }
  return triangles;
}

LightView random_view() {
  const std::array<glm::dvec3, 4> bounds{kCentre + 4.0 * kAxis + glm::dvec3(3.0, 0.0, 0.0),
                                         kCentre + 4.0 * kAxis + glm::dvec3(-2.0, 0.0, 0.0),
                                         kCentre + 5.0 * kAxis + glm::dvec3(0.0, 0.0, 2.0),
                                         kCentre + 3.0 * kAxis + glm::dvec3(0.0, 0.0, -3.0)};
  return make_light_view(kCentre, kAxis, kNear, bounds, kSize);
}

// Where a ray meets a triangle, by barycentric coordinates; the least of them is how far inside.
struct Hit {
  double along;
  std::array<double, 3> weights;
  double margin() const { return std::min({weights[0], weights[1], weights[2]}); }
};

std::optional<Hit> hit(const glm::dvec3& from, const glm::dvec3& way, const Triangle& t) {
  const glm::dvec3 n = glm::cross(t[1] - t[0], t[2] - t[0]);
  const double slope = glm::dot(n, way);
  if (std::abs(slope) < 1e-6) return std::nullopt;
  const double along = glm::dot(n, t[0] - from) / slope;
  const glm::dvec3 p = from + along * way;
  Hit result{along, {}};
  for (std::size_t i = 0; i < 3; ++i) {
    const glm::dvec3& a = t[(i + 1) % 3];
    const glm::dvec3& b = t[(i + 2) % 3];
    result.weights[i] = glm::dot(n, glm::cross(b - a, p - a)) / glm::dot(n, n);
  }
  return result;
}

// Is what a texel holds the distance that a ray through its centre has to the nearest (farthest)
// triangle, or, interpolated, the corners' distances weighted by the place on the triangle?
TEST(LightMap, DistancesAreThoseOfRays) {
  Random random(61);
  const std::vector<Triangle> triangles = random_triangles(random, 60);
  const LightView view = random_view();
  const MapRays rays(view);
  for (const Keep keep : {Keep::nearest, Keep::farthest}) {
    for (const Distances distances : {Distances::exact, Distances::interpolated}) {
      const std::vector<float> map = draw_distances(view, triangles, keep, -1.0F, distances);
      int compared = 0;
      for (int y = 0; y < kSize; ++y) {
        for (int x = 0; x < kSize; ++x) {
          const glm::dvec3 way = rays.at(x + 0.5, y + 0.5);
          double kept = -1.0;
          bool doubtful = false;  // near an edge or the near plane, where snapping decides
          for (const Triangle& t : triangles) {
            const auto found = hit(kCentre, way, t);
            if (!found || found->margin() < -0.03 || found->along < 0.9 * kNear) continue;
            doubtful |= found->margin() < 0.03 || found->along < 1.1 * kNear;
            double distance = found->along * glm::length(way);
            if (distances == Distances::interpolated) {
              distance = 0.0;
              for (std::size_t i = 0; i < 3; ++i) {
                distance += found->weights[i] * glm::distance(t[i], kCentre);
              }
            }
            const bool better = keep == Keep::nearest ? distance < kept : distance > kept;
            if (kept < 0.0 || better) kept = distance;
          }
          if (doubtful) continue;
          ++compared;
          ASSERT_NEAR(map[static_cast<std::size_t>(y * kSize + x)], kept, 1e-5 * (1.0 + kept))
              << x << ' ' << y;
        }
      }
      EXPECT_GT(compared, kSize * kSize / 3);
    }
  }
}

// Are places and rays each other's inverse, and does the view show its points and little else?
TEST(LightMap, ViewIsTightAndGoesBothWays) {
  Random random(62);
  std::vector<glm::dvec3> points;
  for (int i = 0; i < 50; ++i) {
    points.push_back(kCentre + 4.0 * kAxis + random.in_box(glm::dvec3(-2.0), glm::dvec3(2.0)));
  }
  const LightView view = make_light_view(kCentre, kAxis, kNear, points, kSize);
  const MapRays rays(view);
  double x_low = 1e9, x_high = -1e9, y_low = 1e9, y_high = -1e9;
  for (const glm::dvec3& p : points) {
    const MapPlace place = place_in(view, p);
    const glm::dvec3 back = kCentre + place.w * rays.at(place.x, place.y);
    EXPECT_LT(glm::distance(back, p), 1e-9);
    EXPECT_NEAR(place.w * rays.length(place.x, place.y), glm::distance(p, kCentre), 1e-9);
    x_low = std::min(x_low, place.x);
    x_high = std::max(x_high, place.x);
    y_low = std::min(y_low, place.y);
    y_high = std::max(y_high, place.y);
  }
  EXPECT_NEAR(x_low, 0.5, 1e-6);
  EXPECT_NEAR(y_low, 0.5, 1e-6);
  EXPECT_NEAR(x_high, kSize - 0.5, 1e-6);
  EXPECT_NEAR(y_high, kSize - 0.5, 1e-6);
  const std::array<glm::dvec3, 1> behind{kCentre - kAxis};
  EXPECT_EQ(make_light_view(kCentre, kAxis, kNear, behind, kSize).width, 0);
}

TEST(LightMap, SameWhateverTheThreads) {
  Random random(63);
  const std::vector<Triangle> triangles = random_triangles(random, 3000);
  const LightView view = random_view();
  const std::vector<float> parallel = draw_distances(view, triangles, Keep::nearest, 0.0F);
  const tbb::global_control one(tbb::global_control::max_allowed_parallelism, 1);
  EXPECT_EQ(draw_distances(view, triangles, Keep::nearest, 0.0F), parallel);
}

// The D-buffer's paper calls linear interpolation of distances inaccurate where triangles are
// large: of a wall 2 wide at distance 1 its corners' distances say 1.73 in the middle.
TEST(LightMap, InterpolatedDistancesAreWrongInsideLargeTriangles) {
  for (const double half : {1.0, 0.1}) {
    const std::array<glm::dvec3, 4> square{
        glm::dvec3(-half, -half, 1.0), glm::dvec3(half, -half, 1.0), glm::dvec3(half, half, 1.0),
        glm::dvec3(-half, half, 1.0)};
    const std::vector<Triangle> wall{{square[0], square[1], square[2]},
                                     {square[0], square[2], square[3]}};
    const LightView view =
        make_light_view(glm::dvec3(0.0), glm::dvec3(0.0, 0.0, 1.0), 0.5, square, 65);
    const std::size_t middle = 32 * 65 + 32;
    const auto exact = draw_distances(view, wall, Keep::nearest, 0.0F);
    const auto linear = draw_distances(view, wall, Keep::nearest, 0.0F, Distances::interpolated);
    EXPECT_NEAR(exact[middle], 1.0, 1e-6);
    EXPECT_NEAR(linear[middle], std::sqrt(1.0 + 2.0 * half * half), 1e-3);
  }
}

}  // namespace
}  // namespace wedgesim::functional
