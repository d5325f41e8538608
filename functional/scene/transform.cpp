#include "functional/scene/transform.h"

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/trigonometric.hpp>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::functional {
namespace {

struct Turn {
  double cosine;
  double sine;
};

Turn turn_of(double degrees) {
  const double quarter = std::remainder(degrees, 360.0) / 90.0;
  if (quarter == std::nearbyint(quarter)) {
    const int quarters = (static_cast<int>(quarter) + 4) % 4;
    constexpr Turn kQuarters[] = {{1.0, 0.0}, {0.0, 1.0}, {-1.0, 0.0}, {0.0, -1.0}};
    return kQuarters[quarters];
  }
  return {std::cos(glm::radians(degrees)), std::sin(glm::radians(degrees))};
}

}  // namespace

Mesh placed(Mesh mesh, const Placement& placement) {
  const Turn x = turn_of(placement.turn_degrees.x);
  const Turn y = turn_of(placement.turn_degrees.y);
  const Turn z = turn_of(placement.turn_degrees.z);
  for (glm::dvec3& position : mesh.positions) {
    glm::dvec3 p = position * placement.scale;
    p = {p.x, x.cosine * p.y - x.sine * p.z, x.sine * p.y + x.cosine * p.z};
    p = {y.cosine * p.x + y.sine * p.z, p.y, y.cosine * p.z - y.sine * p.x};
    p = {z.cosine * p.x - z.sine * p.y, z.sine * p.x + z.cosine * p.y, p.z};
    position = p + placement.position;
  }
  return mesh;
}

std::pair<glm::dvec3, glm::dvec3> bounds_of(const Mesh& mesh) {
  CHECK_GT(mesh.positions.size(), 0U);
  glm::dvec3 low = mesh.positions.front();
  glm::dvec3 high = low;
  for (const glm::dvec3& p : mesh.positions) {
    low = glm::min(low, p);
    high = glm::max(high, p);
  }
  return {low, high};
}

Mesh fitted(Mesh mesh, double size) {
  const auto [low, high] = bounds_of(mesh);
  const glm::dvec3 extent = high - low;
  const double largest = std::max({extent.x, extent.y, extent.z});
  if (!(largest > 0.0)) {
    throw InputError(mesh.name, "the mesh has no extent", "a mesh larger than a point");
  }
  const glm::dvec3 foot{0.5 * (low.x + high.x), low.y, 0.5 * (low.z + high.z)};
  for (glm::dvec3& position : mesh.positions) {
    position = (position - foot) * (size / largest);
  }
  return mesh;
}

}  // namespace wedgesim::functional
