#include "functional/scene/landscape.h"

#include <algorithm>
#include <cmath>

#include "functional/scene/primitives.h"
#include "functional/scene/transform.h"

namespace wedgesim::functional {
namespace {

/// A number in [0, 1) for a lattice point; mixing by the finalizer of MurmurHash3.
double lattice_value(std::int64_t x, std::int64_t z, std::uint32_t seed) {
  std::uint64_t h = static_cast<std::uint64_t>(x) * 0x9E3779B97F4A7C15U ^
                    static_cast<std::uint64_t>(z) * 0xC2B2AE3D27D4EB4FU ^
                    (static_cast<std::uint64_t>(seed) + 1U) * 0x165667B19E3779F9U;
  h = (h ^ (h >> 33U)) * 0xFF51AFD7ED558CCDU;
  h = (h ^ (h >> 33U)) * 0xC4CEB9FE1A85EC53U;
  h ^= h >> 33U;
  return static_cast<double>(h >> 11U) * 0x1p-53;
}

double smooth(double t) { return t * t * t * (t * (6.0 * t - 15.0) + 10.0); }

double noise(glm::dvec2 p, std::uint32_t seed) {
  const glm::dvec2 cell{std::floor(p.x), std::floor(p.y)};
  const auto x = static_cast<std::int64_t>(cell.x);
  const auto z = static_cast<std::int64_t>(cell.y);
  const double u = smooth(p.x - cell.x);
  const double v = smooth(p.y - cell.y);
  const auto mix = [](double a, double b, double t) { return a + t * (b - a); };
  return mix(mix(lattice_value(x, z, seed), lattice_value(x + 1, z, seed), u),
             mix(lattice_value(x, z + 1, seed), lattice_value(x + 1, z + 1, seed), u), v);
}

}  // namespace

Mesh make_landscape(const LandscapeStyle& style) {
  Mesh mesh = make_plane(style.size, {style.cells, style.cells});
  for (glm::dvec3& position : mesh.positions) {
    glm::dvec2 p = style.features * (glm::dvec2(position.x, position.z) / style.size + 0.5);
    double weight = 1.0;
    for (int octave = 0; octave < style.octaves; ++octave) {
      position.y += weight * noise(p, style.seed + static_cast<std::uint32_t>(octave));
      weight *= 0.5;
      p *= 2.0;
    }
  }
  const auto [low, high] = bounds_of(mesh);
  for (glm::dvec3& position : mesh.positions) {
    position.y = style.height * (position.y - low.y) / (high.y - low.y);
  }
  return mesh;
}

}  // namespace wedgesim::functional
