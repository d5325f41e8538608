#include "functional/scene/skin.h"

#include <cmath>
#include <glm/geometric.hpp>
#include <glm/gtc/constants.hpp>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::functional {
namespace {

using Ring = std::vector<glm::dvec3>;

void join(Mesh& mesh, std::uint32_t lower, std::size_t lower_size, std::uint32_t upper,
          std::size_t upper_size) {
  const auto n = static_cast<std::uint32_t>(std::max(lower_size, upper_size));
  for (std::uint32_t i = 0; i < n; ++i) {
    const std::uint32_t next = (i + 1) % n;
    if (lower_size == 1) {
      mesh.triangles.push_back({lower, upper + next, upper + i});
    } else if (upper_size == 1) {
      mesh.triangles.push_back({lower + i, lower + next, upper});
    } else {
      mesh.triangles.push_back({lower + i, lower + next, upper + next});
      mesh.triangles.push_back({lower + i, upper + next, upper + i});
    }
  }
}

/// A circle right-handed about `axis_u` × `axis_v`.
Ring circle(glm::dvec3 centre, glm::dvec3 axis_u, glm::dvec3 axis_v, double radius, int segments) {
  Ring ring;
  for (int i = 0; i < segments; ++i) {
    const double angle = glm::two_pi<double>() * i / segments;
    ring.push_back(centre + radius * (std::cos(angle) * axis_u + std::sin(angle) * axis_v));
  }
  return ring;
}

}  // namespace

Mesh skin(const std::vector<Ring>& rings, bool loop) {
  Mesh mesh;
  std::vector<std::uint32_t> first;
  for (const Ring& ring : rings) {
    first.push_back(static_cast<std::uint32_t>(mesh.positions.size()));
    mesh.positions.insert(mesh.positions.end(), ring.begin(), ring.end());
  }
  for (std::size_t i = 0; i + 1 < rings.size(); ++i) {
    CHECK_GT(rings[i].size() + rings[i + 1].size(), 2U);
    join(mesh, first[i], rings[i].size(), first[i + 1], rings[i + 1].size());
  }
  if (loop) {
    join(mesh, first.back(), rings.back().size(), first.front(), rings.front().size());
  }
  return mesh;
}

Mesh make_lathe(const std::vector<glm::dvec2>& profile, int segments) {
  CHECK_GE(profile.size(), 2U);
  CHECK_GE(segments, 3);
  std::vector<Ring> rings;
  const auto pole = [](double height) { return Ring{glm::dvec3(0.0, height, 0.0)}; };
  for (std::size_t i = 0; i < profile.size(); ++i) {
    const bool end = i == 0 || i + 1 == profile.size();
    const glm::dvec2 point = profile[i];
    if (point.x < 0.0 || (point.x == 0.0 && !end)) {
      throw InputError("profile", "a radius is negative, or 0 before the end",
                       "radii above 0, or 0 at either end");
    }
    if (point.x == 0.0) {
      rings.push_back(pole(point.y));
      continue;
    }
    if (i == 0) {
      rings.push_back(pole(point.y));
    }
    rings.push_back(
        circle({0.0, point.y, 0.0}, {1.0, 0.0, 0.0}, {0.0, 0.0, -1.0}, point.x, segments));
    if (i + 1 == profile.size()) {
      rings.push_back(pole(point.y));
    }
  }
  return skin(rings);
}

Mesh make_sweep(const std::vector<glm::dvec3>& path, const std::vector<double>& radii,
                int segments) {
  CHECK_GE(path.size(), 2U);
  CHECK_EQ(path.size(), radii.size());
  CHECK_GE(segments, 3);
  std::vector<Ring> rings{{path.front()}};
  glm::dvec3 side{0.0};
  for (std::size_t i = 0; i < path.size(); ++i) {
    const glm::dvec3 along =
        glm::normalize(path[std::min(i + 1, path.size() - 1)] - path[i == 0 ? 0 : i - 1]);
    if (i == 0) {
      side = std::abs(along.y) < 0.9 ? glm::dvec3(0.0, 1.0, 0.0) : glm::dvec3(1.0, 0.0, 0.0);
    }
    side = glm::normalize(side - glm::dot(side, along) * along);
    rings.push_back(circle(path[i], side, glm::cross(along, side), radii[i], segments));
  }
  rings.push_back({path.back()});
  return skin(rings);
}

}  // namespace wedgesim::functional
