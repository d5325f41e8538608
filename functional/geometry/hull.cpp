#include "functional/geometry/hull.h"

#include <algorithm>
#include <numeric>

namespace wedgesim::functional {
namespace {

double turn(const glm::dvec2& a, const glm::dvec2& b, const glm::dvec2& c) {
  return (b.x - a.x) * (c.y - b.y) - (b.y - a.y) * (c.x - b.x);
}

}  // namespace

std::vector<std::size_t> convex_hull_indices(const std::vector<glm::dvec2>& points) {
  std::vector<std::size_t> order(points.size());
  std::iota(order.begin(), order.end(), std::size_t{0});
  std::sort(order.begin(), order.end(), [&](std::size_t i, std::size_t j) {
    const glm::dvec2& a = points[i];
    const glm::dvec2& b = points[j];
    return a.x != b.x ? a.x < b.x : (a.y != b.y ? a.y < b.y : i < j);
  });
  order.erase(std::unique(order.begin(), order.end(),
                          [&](std::size_t i, std::size_t j) { return points[i] == points[j]; }),
              order.end());
  if (order.size() < 3) return order;
  std::vector<std::size_t> hull;
  const auto add = [&](std::size_t i, std::size_t base) {
    while (hull.size() > base + 1 &&
           turn(points[hull[hull.size() - 2]], points[hull.back()], points[i]) <= 0.0) {
      hull.pop_back();
    }
    hull.push_back(i);
  };
  for (const std::size_t i : order) add(i, 0);
  const std::size_t lower = hull.size() - 1;
  for (std::size_t k = order.size() - 1; k-- > 0;) add(order[k], lower);
  hull.pop_back();
  return hull;
}

std::vector<glm::dvec2> convex_hull(const std::vector<glm::dvec2>& points) {
  std::vector<glm::dvec2> hull;
  for (const std::size_t i : convex_hull_indices(points)) hull.push_back(points[i]);
  return hull;
}

}  // namespace wedgesim::functional
