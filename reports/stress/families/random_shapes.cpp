#include "reports/stress/families/random_shapes.h"

#include <cmath>
#include <glm/trigonometric.hpp>
#include <utility>

namespace wedgesim::reports::stress {
namespace {

// Two rings of n corners, the lower one first, between two fans.
Shape prism(int n, double start_low, double start_high, double radius) {
  Shape shape;
  for (const auto& [y, start] : {std::pair{-1.0, start_low}, std::pair{1.0, start_high}}) {
    for (int i = 0; i < n; ++i) {
      const double angle = glm::radians(start + 360.0 * i / n);
      // Rounded, so that corners of a square are on a grid.
      shape.corners.emplace_back(std::round(64.0 * radius * std::cos(angle)) / 64.0, y,
                                 std::round(64.0 * radius * std::sin(angle)) / 64.0);
    }
  }
  const auto count = static_cast<std::uint32_t>(n);
  for (std::uint32_t i = 0; i < count; ++i) {
    const std::uint32_t j = (i + 1) % count;
    shape.triangles.push_back({i, i + count, j});
    shape.triangles.push_back({j, i + count, j + count});
    if (i >= 1 && j != 0) {
      shape.triangles.push_back({0, i, j});
      shape.triangles.push_back({count, j + count, i + count});
    }
  }
  return shape;
}

// Two pyramids over a star of three points.
Shape star() {
  Shape shape;
  for (int i = 0; i < 6; ++i) {
    const double radius = i % 2 == 0 ? 1.0 : 0.375;
    const double angle = glm::radians(60.0 * i);
    shape.corners.emplace_back(radius * std::cos(angle), 0.0, radius * std::sin(angle));
  }
  shape.corners.emplace_back(0.0, 1.0, 0.0);
  shape.corners.emplace_back(0.0, -1.0, 0.0);
  for (std::uint32_t i = 0; i < 6; ++i) {
    const std::uint32_t j = (i + 1) % 6;
    shape.triangles.push_back({6, j, i});
    shape.triangles.push_back({7, i, j});
  }
  return shape;
}

}  // namespace

Shape shape_of(int number) {
  switch (number) {
    case 0:
      return {{{0, 1, 0}, {1, -1, 0}, {-1, -1, 1}, {-1, -1, -1}},
              {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}, {1, 2, 3}}};
    case 1:
      return {
          {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
          {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    case 2:
      return prism(3, 0.0, 0.0, 1.0);
    case 3:
      return prism(4, 45.0, 45.0, std::sqrt(2.0));
    case 4:
      return star();
    default:
      return prism(4, 0.0, 45.0, 1.0);  // twisted
  }
}

}  // namespace wedgesim::reports::stress
