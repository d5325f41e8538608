#pragma once

#include <array>
#include <cstdint>
#include <filesystem>
#include <glm/vec3.hpp>
#include <memory>
#include <string>
#include <vector>

#include "base/image.h"

namespace wedgesim::functional {

/// An edge between two vertices and the triangles that run along it from the lower to the higher
/// and back.
struct MeshEdge {
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t low = 0, high = 0;
  std::uint32_t forward = kNone, backward = kNone;
};

/// Triangles over shared vertices; counter-clockwise seen from outside.
struct Mesh {
  std::string name;
  std::vector<glm::dvec3> positions;                    // world units
  std::vector<std::array<std::uint32_t, 3>> triangles;  // indices into positions
  /// Of a caster that was read: mesh_edges of its triangles, which do not change. Else none.
  std::vector<MeshEdge> edges;
};

/// A mesh in the world. Every object receives shadows; a caster must be a closed two-manifold.
struct Object {
  Mesh mesh;
  bool casts = false;
  glm::dvec3 colour{0.8};  // linear reflectance, [0, 1]
};

enum class LightShape { point, rectangle, sphere };

struct Light {
  LightShape shape = LightShape::rectangle;
  glm::dvec3 centre{0.0};
  glm::dvec3 half_u{0.0};  // rectangle: half axes, orthogonal; it shines along half_u × half_v
  glm::dvec3 half_v{0.0};
  double radius = 0.0;  // sphere
  glm::dvec3 colour{1.0};
  /// Of a rectangle, may be null: its emission, 3 channels, 0 and above. Columns run along half_u,
  /// rows along half_v; of the power of each colour a texel emits its share of the sum.
  std::shared_ptr<const Image> texture;
};

/// Whether a light has an area; one without casts hard shadows.
inline bool has_extent(const Light& light) {
  if (light.shape == LightShape::rectangle) {
    return light.half_u != glm::dvec3(0.0) && light.half_v != glm::dvec3(0.0);
  }
  return light.shape == LightShape::sphere && light.radius > 0.0;
}

struct Camera {
  glm::dvec3 eye{0.0};
  glm::dvec3 target{0.0};
  glm::dvec3 up{0.0, 1.0, 0.0};
  double field_of_view_degrees = 45.0;  // vertical
  double near_plane = 0.1;              // world units
  double far_plane = 100.0;
};

/// One frame: everything the renderer needs.
struct Scene {
  std::string name;
  std::string place = "scene";               // its file, as errors name it
  std::vector<std::filesystem::path> files;  // that it was read from; none of a built-in scene
  std::string description;
  int frame = 0;   // of the camera path
  int frames = 1;  // how many frames the camera path has
  int width = 640;
  int height = 427;
  Camera camera;
  Light light;
  std::vector<Light> other_lights;  // besides it; lights.h takes one at a time
  std::vector<Object> objects;
};

}  // namespace wedgesim::functional
