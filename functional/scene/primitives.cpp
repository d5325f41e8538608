#include "functional/scene/primitives.h"

#include <fmt/format.h>

#include <cmath>
#include <glm/gtc/constants.hpp>

#include "base/check.h"
#include "base/error.h"
#include "functional/scene/skin.h"

namespace wedgesim::functional {

Mesh make_box(glm::dvec3 size) {
  const glm::dvec3 half = 0.5 * size;
  const auto ring = [&half](double y) {
    return std::vector<glm::dvec3>{
        {-half.x, y, half.z}, {half.x, y, half.z}, {half.x, y, -half.z}, {-half.x, y, -half.z}};
  };
  Mesh mesh = skin({ring(0.0), ring(size.y)});
  mesh.triangles.push_back({0, 3, 2});
  mesh.triangles.push_back({0, 2, 1});
  mesh.triangles.push_back({4, 5, 6});
  mesh.triangles.push_back({4, 6, 7});
  return mesh;
}

Mesh make_plane(glm::dvec2 size, glm::ivec2 cells) {
  CHECK_GE(cells.x, 1);
  CHECK_GE(cells.y, 1);
  Mesh mesh;
  for (int row = 0; row <= cells.y; ++row) {
    for (int column = 0; column <= cells.x; ++column) {
      mesh.positions.emplace_back(size.x * (static_cast<double>(column) / cells.x - 0.5), 0.0,
                                  size.y * (static_cast<double>(row) / cells.y - 0.5));
    }
  }
  const auto stride = static_cast<std::uint32_t>(cells.x + 1);
  for (std::uint32_t row = 0; row < static_cast<std::uint32_t>(cells.y); ++row) {
    for (std::uint32_t column = 0; column + 1 < stride; ++column) {
      const std::uint32_t corner = row * stride + column;
      mesh.triangles.push_back({corner, corner + stride, corner + stride + 1});
      mesh.triangles.push_back({corner, corner + stride + 1, corner + 1});
    }
  }
  return mesh;
}

Mesh make_thin_polygon(const std::vector<glm::dvec2>& points) {
  const std::size_t n = points.size();
  const std::string expected = "4 or more points, convex, counter-clockwise seen from above";
  if (n < 4) {
    throw InputError("points", fmt::format("there are {}", n), expected);
  }
  Mesh mesh;
  for (std::size_t i = 0; i < n; ++i) {
    const glm::dvec2 edge = points[(i + 1) % n] - points[i];
    for (std::size_t k = 2; k < n; ++k) {
      const glm::dvec2 other = points[(i + k) % n] - points[i];
      // Seen from above, z points down the page: what lies left of the edge has a negative sign.
      if (!(edge.x * other.y - edge.y * other.x < 0.0)) {
        throw InputError("points", fmt::format("point {} is not left of edge {}", (i + k) % n, i),
                         expected);
      }
    }
    mesh.positions.emplace_back(points[i].x, 0.0, points[i].y);
  }
  // Fans from two neighbouring corners share no inner edge.
  for (std::uint32_t i = 1; i + 1 < n; ++i) {
    mesh.triangles.push_back({0, i, i + 1});
    const auto at = [n](std::uint32_t k) { return (k + 1) % static_cast<std::uint32_t>(n); };
    mesh.triangles.push_back({at(0), at(i + 1), at(i)});
  }
  return mesh;
}

Mesh make_torus(double radius, double tube, int segments, int tube_segments) {
  CHECK_GE(segments, 3);
  CHECK_GE(tube_segments, 3);
  CHECK_GT(radius, tube);
  std::vector<std::vector<glm::dvec3>> rings;
  for (int i = 0; i < segments; ++i) {
    const double around = glm::two_pi<double>() * i / segments;
    std::vector<glm::dvec3>& ring = rings.emplace_back();
    for (int j = 0; j < tube_segments; ++j) {
      const double angle = glm::two_pi<double>() * j / tube_segments;
      const double out = radius + tube * std::cos(angle);
      ring.emplace_back(out * std::cos(around), -tube * std::sin(angle), -out * std::sin(around));
    }
  }
  return skin(rings, true);
}

Mesh make_sphere(double radius, int segments, int rings) {
  CHECK_GE(rings, 2);
  std::vector<glm::dvec2> profile;
  for (int i = 0; i <= rings; ++i) {
    const double angle = glm::pi<double>() * i / rings;
    const bool pole = i == 0 || i == rings;
    profile.emplace_back(pole ? 0.0 : radius * std::sin(angle), -radius * std::cos(angle));
  }
  return make_lathe(profile, segments);
}

}  // namespace wedgesim::functional
