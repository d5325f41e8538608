#include "tests/support/random_scene.h"

#include <fmt/format.h>

#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <map>
#include <utility>
#include <vector>

namespace wedgesim::tests {
namespace {

using functional::Mesh;
using Triangle = std::array<std::uint32_t, 3>;

class Random {
 public:
  explicit Random(std::uint64_t seed) : engine_(seed) {}
  // By hand, because the standard's distributions differ between libraries.
  double between(double low, double high) {
    return low + (high - low) * (static_cast<double>(engine_() >> 11U) / 9007199254740992.0);
  }
  int count(int low, int high) {
    return low + static_cast<int>(engine_() % static_cast<std::uint64_t>(high - low + 1));
  }
  glm::dvec3 direction() {
    for (;;) {
      const glm::dvec3 d{between(-1, 1), between(-1, 1), between(-1, 1)};  // braces: in order
      const double length = glm::length(d);
      if (length > 0.1 && length < 1.0) return d / length;
    }
  }

 private:
  std::mt19937_64 engine_;
};

Mesh deformed_sphere(Random& random) {
  Mesh mesh;
  mesh.positions = {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}};
  mesh.triangles = {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4},
                    {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}};
  for (int level = random.count(0, 2); level > 0; --level) {
    std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> middles;
    const auto middle = [&](std::uint32_t a, std::uint32_t b) {
      const auto [it, added] = middles.try_emplace(
          {std::min(a, b), std::max(a, b)}, static_cast<std::uint32_t>(mesh.positions.size()));
      if (added) {
        mesh.positions.push_back(glm::normalize(mesh.positions[a] + mesh.positions[b]));
      }
      return it->second;
    };
    std::vector<Triangle> finer;
    for (const auto& [a, b, c] : mesh.triangles) {
      const std::uint32_t ab = middle(a, b);
      const std::uint32_t bc = middle(b, c);
      const std::uint32_t ca = middle(c, a);
      finer.insert(finer.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    mesh.triangles = std::move(finer);
  }
  const double roughness = random.between(0.0, 0.5);
  for (glm::dvec3& p : mesh.positions) p *= 1.0 + random.between(-roughness, roughness);
  return mesh;
}

Mesh torus(Random& random) {
  Mesh mesh;
  const int around = random.count(4, 8);
  const int across = random.count(3, 5);
  const double thickness = random.between(0.15, 0.4);
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      const double a = 2 * M_PI * i / around;
      const double b = 2 * M_PI * j / across;
      const double r = 1.0 + thickness * std::cos(b) * random.between(0.8, 1.2);
      mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), thickness * std::sin(b));
    }
  }
  const auto at = [&](int i, int j) {
    return static_cast<std::uint32_t>((i % around) * across + j % across);
  };
  for (int i = 0; i < around; ++i) {
    for (int j = 0; j < across; ++j) {
      mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
      mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
    }
  }
  return mesh;
}

Mesh star_prism(Random& random) {
  Mesh mesh;
  const int n = random.count(3, 9);
  const double height = random.between(0.05, 1.0);
  for (int i = 0; i < n; ++i) {
    const double a = 2 * M_PI * i / n;
    const double r = random.between(0.35, 1.0);
    mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), -height / 2);
    mesh.positions.emplace_back(r * std::cos(a), r * std::sin(a), height / 2);
  }
  const auto below = static_cast<std::uint32_t>(mesh.positions.size());
  mesh.positions.emplace_back(0, 0, -height / 2);
  mesh.positions.emplace_back(0, 0, height / 2);
  for (int i = 0; i < n; ++i) {
    const auto a = static_cast<std::uint32_t>(2 * i);
    const auto b = static_cast<std::uint32_t>(2 * ((i + 1) % n));
    mesh.triangles.insert(
        mesh.triangles.end(),
        {{below, b, a}, {below + 1, a + 1, b + 1}, {a, b, b + 1}, {a, b + 1, a + 1}});
  }
  return mesh;
}

Mesh random_mesh(Random& random) {
  switch (random.count(0, 3)) {
    case 0:
      return torus(random);
    case 1:
      return star_prism(random);
    default:
      return deformed_sphere(random);
  }
}

// Turned, scaled unevenly and moved.
void place(Random& random, Mesh& mesh, const glm::dvec3& centre, double size) {
  const glm::dvec3 x = random.direction();
  const glm::dvec3 y = glm::normalize(glm::cross(x, random.direction()));
  const glm::dvec3 z = glm::cross(x, y);
  const glm::dvec3 scale{size * random.between(0.4, 1.0), size * random.between(0.4, 1.0),
                         size * random.between(0.4, 1.0)};
  for (glm::dvec3& p : mesh.positions) {
    p = centre + scale.x * p.x * x + scale.y * p.y * y + scale.z * p.z * z;
  }
}

Mesh bumpy_floor(Random& random) {
  Mesh mesh;
  mesh.name = "floor";
  constexpr int kCells = 6;
  const double bump = random.between(0.0, 0.4);
  for (int i = 0; i <= kCells; ++i) {
    for (int j = 0; j <= kCells; ++j) {
      mesh.positions.emplace_back(4.0 * (2.0 * j / kCells - 1.0), random.between(-bump, 0.0),
                                  4.0 * (2.0 * i / kCells - 1.0));
    }
  }
  for (std::uint32_t i = 0; i < kCells; ++i) {
    for (std::uint32_t j = 0; j < kCells; ++j) {
      const std::uint32_t a = i * (kCells + 1) + j;
      const std::uint32_t b = a + kCells + 1;
      mesh.triangles.push_back({a, b, a + 1});
      mesh.triangles.push_back({a + 1, b, b + 1});
    }
  }
  return mesh;
}

}  // namespace

functional::Scene random_scene(std::uint64_t seed, EyePlace place_of_eye) {
  Random random(seed);
  functional::Scene scene;
  scene.name = fmt::format("random-{}", seed);
  scene.width = random.count(9, 48);
  scene.height = random.count(7, 36);
  scene.objects.push_back({bumpy_floor(random), false, {}});
  const int casters = random.count(1, 3);
  for (int i = 0; i < casters; ++i) {
    Mesh mesh = random_mesh(random);
    mesh.name = fmt::format("caster-{}", i);
    place(random, mesh,
          {random.between(-1.2, 1.2), random.between(1.0, 2.2), random.between(-1.2, 1.2)},
          random.between(0.3, 0.9));
    scene.objects.push_back({std::move(mesh), true, {}});
  }

  functional::Light& light = scene.light;
  light.centre = {random.between(-2.5, 2.5), random.between(5.0, 9.0), random.between(-2.5, 2.5)};
  const double size = random.between(0.05, 1.0);
  if (random.count(0, 2) == 0) {
    light.shape = functional::LightShape::sphere;
    light.radius = size;
  } else {
    const glm::dvec3 normal =
        glm::normalize(glm::dvec3(0, 1, 0) - light.centre + 0.4 * random.direction());
    const glm::dvec3 u = glm::normalize(glm::cross(normal, random.direction()));
    light.half_u = size * u;
    light.half_v = size * random.between(0.2, 1.0) * glm::cross(normal, u);
  }

  functional::Camera& camera = scene.camera;
  camera.near_plane = 0.02;
  camera.far_plane = 60.0;
  camera.field_of_view_degrees = random.between(25.0, 80.0);
  if (place_of_eye == EyePlace::outside) {
    const double angle = random.between(0.0, 2 * M_PI);
    const double distance = random.between(5.0, 9.0);
    camera.eye = {distance * std::cos(angle), random.between(1.0, 6.0), distance * std::sin(angle)};
    camera.target = {random.between(-0.8, 0.8), random.between(0.0, 1.0),
                     random.between(-0.8, 0.8)};
  } else {
    // Below a caster, on the ray from the light through its middle.
    const Mesh& mesh = scene.objects[1].mesh;
    glm::dvec3 middle(0.0);
    for (const glm::dvec3& p : mesh.positions) middle += p / double(mesh.positions.size());
    const glm::dvec3 ray = middle - light.centre;
    const double floor_share = (0.15 - light.centre.y) / ray.y;
    camera.eye = light.centre + random.between(1.0 + 0.7 * (floor_share - 1.0), floor_share) * ray;
    camera.target = camera.eye + glm::dvec3{random.between(-1, 1), random.between(-0.6, 0.1),
                                            random.between(-1, 1)};
  }
  return scene;
}

}  // namespace wedgesim::tests
