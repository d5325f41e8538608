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

// How far the points reach, over all directions.
double reach(const std::vector<glm::dvec2>& points) {
  constexpr int kDirections = 16;
  double sum = 0.0;
  for (int i = 0; i < kDirections; ++i) {
    const double angle = M_PI * i / kDirections;
    const glm::dvec2 axis(std::cos(angle), std::sin(angle));
    double low = 1e300;
    double high = -1e300;
    for (const glm::dvec2& p : points) {
      low = std::min(low, glm::dot(axis, p));
      high = std::max(high, glm::dot(axis, p));
    }
    sum += high - low;
  }
  return sum;
}

// Rows and columns matched at random; of some such, the one that reaches farthest. No two points
// are in line with a side, and as seen across a side the points are spread evenly.
std::vector<glm::dvec2> random_samples(int count, std::uint64_t seed) {
  constexpr int kTries = 64;
  std::mt19937_64 random(seed);
  std::vector<int> rows(static_cast<std::size_t>(count));
  for (int i = 0; i < count; ++i) rows[static_cast<std::size_t>(i)] = i;
  std::vector<glm::dvec2> best;
  std::vector<glm::dvec2> points(rows.size());
  for (int attempt = 0; attempt < kTries; ++attempt) {
    for (std::size_t i = rows.size(); i > 1; --i) std::swap(rows[i - 1], rows[random() % i]);
    for (std::size_t i = 0; i < rows.size(); ++i) {
      points[i] = {place(static_cast<int>(i), count), place(rows[i], count)};
    }
    if (best.empty() || reach(points) > reach(best)) best = points;
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
