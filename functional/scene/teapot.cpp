#include "functional/scene/teapot.h"

#include <algorithm>
#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "functional/scene/skin.h"

namespace wedgesim::functional {
namespace {

using Curve = std::array<glm::dvec2, 4>;  // control points of a cubic Bézier curve

// M. Newell's teapot (1975): radius and height of the profile, in his units.
constexpr Curve kBody[] = {
    {{{1.5, 0.0}, {1.5, 0.075}, {2.0, 0.3}, {2.0, 0.75}}},
    {{{2.0, 0.75}, {2.0, 1.2}, {1.75, 1.725}, {1.5, 2.25}}},
    {{{1.5, 2.25}, {1.4375, 2.38125}, {1.3375, 2.38125}, {1.4, 2.25}}},
};
constexpr Curve kLid[] = {
    {{{1.3, 2.2}, {1.3, 2.4}, {0.4, 2.4}, {0.2, 2.55}}},
    {{{0.2, 2.55}, {0.0, 2.7}, {0.8, 3.0}, {0.0, 3.0}}},
};
constexpr double kHeight = 3.0;

// Centre lines in the plane z = 0; the ends lie inside the body.
constexpr Curve kSpout = {{{1.6, 0.85}, {2.7, 0.8}, {2.3, 1.95}, {2.95, 2.3}}};
constexpr Curve kHandle = {{{-1.5, 2.0}, {-3.3, 2.2}, {-3.2, 0.9}, {-1.85, 0.75}}};
constexpr double kSpoutFoot = 0.5;
constexpr double kSpoutTip = 0.16;
constexpr double kHandleRadius = 0.13;

glm::dvec2 at(const Curve& c, double t) {
  const double s = 1.0 - t;
  return s * s * s * c[0] + 3.0 * s * s * t * c[1] + 3.0 * s * t * t * c[2] + t * t * t * c[3];
}

template <std::size_t n>
Mesh turned(const Curve (&curves)[n], int steps, int segments) {
  std::vector<glm::dvec2> profile{curves[0][0]};
  for (const Curve& curve : curves) {
    for (int i = 1; i <= steps; ++i) {
      profile.push_back(at(curve, static_cast<double>(i) / steps));
    }
  }
  return make_lathe(profile, segments);
}

Mesh swept(const Curve& curve, double first_radius, double last_radius, int steps, int segments) {
  std::vector<glm::dvec3> path;
  std::vector<double> radii;
  for (int i = 0; i <= steps; ++i) {
    const double t = static_cast<double>(i) / steps;
    path.emplace_back(at(curve, t), 0.0);
    radii.push_back(first_radius + t * (last_radius - first_radius));
  }
  return make_sweep(path, radii, segments);
}

void append(Mesh& mesh, const Mesh& part, double scale) {
  const auto first = static_cast<std::uint32_t>(mesh.positions.size());
  for (const glm::dvec3& position : part.positions) {
    mesh.positions.push_back(scale * position);
  }
  for (const auto& t : part.triangles) {
    mesh.triangles.push_back({first + t[0], first + t[1], first + t[2]});
  }
}

}  // namespace

Mesh make_teapot(double height, int segments) {
  const int steps = std::max(2, segments / 4);
  const int around = std::max(3, segments / 2);
  Mesh mesh;
  for (const Mesh& part : {turned(kBody, steps, segments), turned(kLid, steps, segments),
                           swept(kSpout, kSpoutFoot, kSpoutTip, 2 * steps, around),
                           swept(kHandle, kHandleRadius, kHandleRadius, 2 * steps, around)}) {
    append(mesh, part, height / kHeight);
  }
  return mesh;
}

}  // namespace wedgesim::functional
