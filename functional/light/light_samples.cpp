#include "functional/light/light_samples.h"

#include <algorithm>
#include <cmath>
#include <glm/geometric.hpp>
#include <random>

#include "base/check.h"
#include "functional/light/unit_disc.h"
#include "functional/scene/across.h"

namespace wedgesim::functional {
namespace {

// A number of a row of `count`, from border to border.
double place(int index, int count) { return count == 1 ? 0.0 : 2.0 * index / (count - 1) - 1.0; }

// Where a share of the square lies below, seen along an axis; from border to border.
double quantile(const glm::dvec2& axis, double share) {
  const double p = std::max(std::abs(axis.x), std::abs(axis.y));
  const double q = std::min(std::abs(axis.x), std::abs(axis.y));
  const double from_end = std::min(share, 1.0 - share);
  const double t = from_end < q / (2.0 * p) ? std::sqrt(8.0 * p * q * from_end) - p - q
                                            : 2.0 * p * (from_end - 0.5);
  return share < 0.5 ? t : -t;
}

// How badly the points stand for the square: the rings of a straight edge lie where the points are
// as seen along it, and should lie where their intensity is. Sum over directions.
double badness(const std::vector<glm::dvec2>& points) {
  constexpr int kDirections = 8;
  double sum = 0.0;
  std::vector<double> along(points.size());
  for (int d = 0; d < kDirections; ++d) {
    const double angle = M_PI * (d + 0.5) / kDirections;
    const glm::dvec2 axis(std::cos(angle), std::sin(angle));
    for (std::size_t i = 0; i < points.size(); ++i) along[i] = glm::dot(axis, points[i]);
    std::sort(along.begin(), along.end());
    for (std::size_t i = 0; i < points.size(); ++i) {
      const double share = static_cast<double>(i) / static_cast<double>(points.size() - 1);
      sum += std::pow(along[i] - quantile(axis, share), 2);
    }
  }
  return sum;
}

// One point in each column, those of neighbouring columns in different parts of the rows.
std::vector<glm::dvec2> stratified(int count, std::mt19937_64& random) {
  struct Point {
    std::uint64_t part, order;  // of the rows; within a part by chance
    int column;
  };
  const int blocks = static_cast<int>(std::lround(std::sqrt(count)));
  std::vector<Point> points;
  for (int block = 0; block < blocks; ++block) {
    const std::size_t first = points.size();
    for (int i = block * count / blocks; i < (block + 1) * count / blocks; ++i) {
      points.push_back({points.size() - first, random(), i});
    }
    for (std::size_t size = points.size() - first; size > 1; --size) {
      std::swap(points[first + size - 1].part, points[first + random() % size].part);
    }
  }
  std::ranges::sort(points, [](const Point& a, const Point& b) {
    return a.part != b.part ? a.part < b.part : a.order < b.order;
  });
  std::vector<glm::dvec2> result;
  for (int row = 0; row < count; ++row) {
    result.emplace_back(place(points[static_cast<std::size_t>(row)].column, count),
                        place(row, count));
  }
  return result;
}

std::vector<glm::dvec2> random_samples(int count, std::uint64_t seed) {
  constexpr int kTries = 32;
  std::mt19937_64 random(seed);
  std::vector<glm::dvec2> best;
  double least = 1e300;
  for (int i = 0; i < kTries; ++i) {
    std::vector<glm::dvec2> points = stratified(count, random);
    const double bad = badness(points);
    if (bad < least) {
      least = bad;
      best = std::move(points);
    }
  }
  return best;
}

std::vector<glm::dvec2> grid_samples(int count) {
  const int side = static_cast<int>(std::sqrt(count + 0.5));
  std::vector<glm::dvec2> points;
  for (int y = 0; y < side; ++y) {
    for (int x = 0; x < side; ++x) points.emplace_back(place(x, side), place(y, side));
  }
  return points;
}

std::vector<glm::dvec2> border_samples(int count, std::uint64_t seed) {
  std::mt19937_64 random(seed);
  const double first = static_cast<double>(random() >> 11U) * 0x1p-53;
  std::vector<glm::dvec2> points;
  for (int i = 0; i < count; ++i) {
    const double around = 4.0 * std::fmod((i + first) / count, 1.0);
    const double along = 2.0 * (around - std::floor(around)) - 1.0;
    const glm::dvec2 on_side(1.0, along);
    switch (static_cast<int>(around)) {
      case 0:
        points.emplace_back(on_side.x, on_side.y);
        break;
      case 1:
        points.emplace_back(-on_side.y, on_side.x);
        break;
      case 2:
        points.emplace_back(-on_side.x, -on_side.y);
        break;
      default:
        points.emplace_back(on_side.y, -on_side.x);
        break;
    }
  }
  return points;
}

}  // namespace

std::vector<glm::dvec2> square_samples(int count, SamplePattern pattern, std::uint64_t seed) {
  CHECK_GE(count, 1);
  if (count == 1) return {glm::dvec2(0.0)};
  if (pattern == SamplePattern::grid) return grid_samples(count);
  if (pattern == SamplePattern::border) return border_samples(count, seed);
  return random_samples(count, seed);
}

std::vector<glm::dvec3> light_samples(const Light& light, int count, SamplePattern pattern,
                                      const glm::dvec3& seen_from, std::uint64_t seed) {
  if (!has_extent(light)) return {light.centre};
  glm::dvec3 u = light.half_u;
  glm::dvec3 v = light.half_v;
  const bool disc = light.shape == LightShape::sphere;
  if (disc) {
    // Cut from the plane through the centre by the cone that touches the sphere.
    const glm::dvec3 way = seen_from - light.centre;
    const double distance = glm::length(way);
    CHECK_GT(distance, light.radius);
    const double radius =
        light.radius / std::sqrt(1.0 - (light.radius / distance) * (light.radius / distance));
    const Across across(way / distance);
    u = radius * across.u;
    v = radius * across.v;
  }
  std::vector<glm::dvec3> points;
  for (const glm::dvec2& s : square_samples(count, pattern, seed)) {
    const glm::dvec2 p = disc ? to_disc(s) : s;
    points.push_back(light.centre + p.x * u + p.y * v);
  }
  return points;
}

}  // namespace wedgesim::functional
