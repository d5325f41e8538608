#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <string>
#include <vector>

#include "traces/trace_generated.h"

namespace wedgesim::traces {

/// "No wedge", "no umbra polygon" in a reference.
inline constexpr std::uint32_t kNone = 0xffffffffU;

/// A plane reference: 2 * index + sign (trace.fbs).
constexpr std::uint32_t plane_reference(std::uint32_t index, bool minus) {
  return 2 * index + (minus ? 1U : 0U);
}
constexpr std::uint32_t plane_index(std::uint32_t reference) { return reference >> 1; }
constexpr bool is_minus(std::uint32_t reference) { return (reference & 1U) != 0; }

struct Light {
  fb::LightShape shape = fb::LightShape_rectangle;
  fb::Vec3 centre, half_u, half_v;
  double radius = 0.0;
  fb::Vec3 colour{1.0, 1.0, 1.0};
  std::uint32_t texture_width = 0, texture_height = 0;
  std::vector<float> texture;  // (texture_height, texture_width, 3)
  fb::Matrix4 light_from_window;
};

struct Caster {
  std::string name;
  std::uint32_t triangles = 0;
  bool z_fail_needed = false;
};

struct Camera {
  fb::Vec3 eye;
  std::array<fb::Vec3, 4> near_rectangle;
  fb::Matrix4 window_from_world, world_from_window;
};

/// What is small enough to be held as plain values whichever way a trace came.
struct Header {
  std::string name;
  std::uint32_t width = 0, height = 0;
  Camera camera;
  std::vector<Light> lights;
  std::vector<Caster> casters;
  fb::DepthFormat depth_format = fb::DepthFormat_unorm24;
  bool z_fail_needed = false;
  fb::ZMethod expected_z_method = fb::ZMethod_pass;
  std::uint64_t checksum = 0;  // of the file; 0 for a trace that was never written
};

/// A trace to read: the tables are spans into a mapped file or into a `Trace`, which must live
/// longer. `expected_li` and `li_sensitivity` may be empty: absent. Fields as in trace.fbs.
struct TraceView {
  Header header;
  std::span<const fb::ScreenVertex> vertices;
  std::span<const std::uint32_t> indices;
  std::span<const fb::Plane> planes;
  std::span<const fb::Face> faces;
  std::span<const fb::Wedge> wedges;
  std::span<const fb::UmbraPolygon> umbra_polygons;
  std::span<const std::uint32_t> depth;   // (height, width) stored words
  std::span<const double> expected_li;    // (height, width) or empty
  std::span<const float> li_sensitivity;  // (height, width) or empty
};

/// A trace to make.
struct Trace {
  Header header;
  std::vector<fb::ScreenVertex> vertices;
  std::vector<std::uint32_t> indices;
  std::vector<fb::Plane> planes;
  std::vector<fb::Face> faces;
  std::vector<fb::Wedge> wedges;
  std::vector<fb::UmbraPolygon> umbra_polygons;
  std::vector<std::uint32_t> depth;
  std::vector<double> expected_li;
  std::vector<float> li_sensitivity;

  TraceView view() const {
    return {header, vertices,       indices, planes,      faces,
            wedges, umbra_polygons, depth,   expected_li, li_sensitivity};
  }
};

}  // namespace wedgesim::traces
