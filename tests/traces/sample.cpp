#include "tests/traces/sample.h"

#include <bit>
#include <random>

#include "traces/depth.h"

namespace wedgesim::traces {
namespace {

using flatbuffers::make_span;

fb::Matrix4 matrix(const std::array<double, 16>& columns) {
  return fb::Matrix4(make_span(columns));
}

const fb::Matrix4 kIdentity =
    matrix({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0});

struct WedgeLinks {
  fb::WedgeKind kind;
  std::uint32_t first_face, face_count, umbra, umbra_plane, caster;
};

fb::Wedge wedge(const std::array<std::uint32_t, 8>& planes, std::uint8_t plane_count,
                const WedgeLinks& links, const std::array<double, 6>& linear_factors) {
  return fb::Wedge(make_span(planes), plane_count, links.kind, links.first_face, links.face_count,
                   links.umbra, links.umbra_plane, 0, links.caster, 0.25, 0.75, {-0.5, 0.25, 3.0},
                   {0.5, -0.25, 3.5}, make_span(linear_factors));
}

}  // namespace

Trace sample_trace() {
  Trace trace;
  Header& header = trace.header;
  header.name = "sample \"\\ \n";
  header.width = 4;
  header.height = 3;
  header.camera.eye = {1.0, 2.0, -0.0};
  header.camera.near_rectangle = {fb::Vec3(0.0, 0.0, 1.0), fb::Vec3(4.0, 0.0, 1.0),
                                  fb::Vec3(4.0, 3.0, 1.0), fb::Vec3(0.0, 3.0, 1.0)};
  // The world is twice the window, and w grows with z.
  header.camera.world_from_window =
      matrix({2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 0.0, 0.0, 0.0, 0.0, 2.0, 1.0, 0.0, 0.0, 0.0, 1.0});
  header.camera.window_from_world =
      matrix({1.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 1.0, -1.0, 0.0, 0.0, 0.0, 2.0});
  Light lamp;
  lamp.centre = {0.0, 5.0, 0.1};
  lamp.half_u = {0.5, 0.0, 0.0};
  lamp.half_v = {0.0, 0.0, 0.25};
  lamp.texture_width = 2;
  lamp.texture_height = 1;
  lamp.texture = {0.0F, 0.1F, 0.2F, 1.0F, 0.5F, 1e-30F};
  lamp.light_from_window = kIdentity;
  Light spot = {};
  spot.shape = fb::LightShape_point;
  spot.light_from_window = kIdentity;
  header.lights = {lamp, spot};
  header.casters = {{"box", 12, true}, {"", 4, false}};
  header.z_fail_needed = true;
  header.expected_z_method = fb::ZMethod_fail;

  trace.vertices = {{0, 0, 0.25}, {256, 0, 0.5}, {256, 256, 0.75}, {-128, 512, 1.5}};
  trace.indices = {0, 1, 2, 0, 2, 3, 1, 2, 3, 0, 1, 2, 3};
  trace.planes = {{1.0, 0.0, 0.0, -0.5}, {0.0, 1.0, 0.0, 0.1}, {0.0, 0.0, 1.0, 1.0 / 3.0}};
  trace.faces = {{0, 3, 0, 0.25, 0.75}, {3, 3, 3, 0.25, 1.5}, {9, 4, 4, 0.25, 1.5}};
  trace.wedges = {
      wedge({0, 3, 5}, 3, {fb::WedgeKind_coverage, 0, 2, 0, 5, 0}, {}),
      wedge({1, 2, 4, 5}, 4, {fb::WedgeKind_linear, 2, 1, kNone, 0, 1},
            {1.0, -2.0, 3.5, 0.1, 1e300, 5e-324}),
  };
  trace.umbra_polygons = {{6, 3, 5, 0, 0, fb::UmbraRole_side, 0.25, 0.75},
                          {9, 4, 2, kNone, 0, fb::UmbraRole_bottom, 0.25, 1.5},
                          {0, 3, kNone, kNone, 1, fb::UmbraRole_cap, 0.25, 0.75}};
  for (std::uint32_t i = 0; i < 12; ++i) {
    trace.depth.push_back(encode_depth(header.depth_format, i / 11.0));
    trace.expected_li.push_back(1.0 - i / 7.0);
    trace.li_sensitivity.push_back(static_cast<float>(i) / 255.0F);
  }
  return trace;
}

namespace {

class Dice {
 public:
  explicit Dice(std::uint64_t seed) : bits_(seed) {}

  std::uint32_t below(std::size_t n) { return static_cast<std::uint32_t>(bits_() % n); }
  bool coin() { return below(2) == 0; }
  /// Any finite double, all magnitudes.
  double number() {
    const auto value = std::bit_cast<double>(bits_());
    return std::isfinite(value) ? value : 0.0;
  }
  double unit() { return static_cast<double>(bits_() >> 11) * 0x1p-53; }
  fb::Vec3 vec3() { return {number(), number(), number()}; }
  fb::Matrix4 matrix4() {
    std::array<double, 16> columns{};
    for (double& element : columns) element = number();
    return matrix(columns);
  }

 private:
  std::mt19937_64 bits_;
};

Light random_light(Dice& dice, bool point) {
  Light light;
  light.shape = point         ? fb::LightShape_point
                : dice.coin() ? fb::LightShape_sphere
                              : fb::LightShape_rectangle;
  light.centre = dice.vec3();
  light.half_u = dice.vec3();
  light.half_v = dice.vec3();
  light.radius = std::abs(dice.number());
  light.colour = dice.vec3();
  light.light_from_window = dice.matrix4();
  if (dice.coin()) {
    light.texture_width = 1 + dice.below(3);
    light.texture_height = 1 + dice.below(3);
    light.texture.resize(3 * std::size_t{light.texture_width} * light.texture_height);
    for (float& texel : light.texture) texel = static_cast<float>(dice.unit());
  }
  return light;
}

Header random_header(Dice& dice) {
  Header header;
  header.name = std::string(dice.below(20), static_cast<char>('a' + dice.below(26)));
  header.width = 1 + dice.below(9);
  header.height = 1 + dice.below(9);
  header.camera.eye = dice.vec3();
  for (fb::Vec3& corner : header.camera.near_rectangle) corner = dice.vec3();
  header.camera.window_from_world = dice.matrix4();
  header.camera.world_from_window = dice.matrix4();
  for (std::uint32_t i = 1 + dice.below(3); i > 0; --i) {
    header.lights.push_back(random_light(dice, i > 1));
  }
  std::swap(header.lights.front(), header.lights.back());  // lights[0] has an extent
  for (std::uint32_t i = 1 + dice.below(3); i > 0; --i) {
    header.casters.push_back({std::string(dice.below(9), 'c'), dice.below(1000), dice.coin()});
    header.z_fail_needed |= header.casters.back().z_fail_needed;
  }
  header.depth_format = static_cast<fb::DepthFormat>(dice.below(4));
  header.expected_z_method = dice.coin() ? fb::ZMethod_pass : fb::ZMethod_fail;
  return header;
}

void add_tables(Dice& dice, Trace& trace) {
  for (std::uint32_t i = 3 + dice.below(30); i > 0; --i) {
    const auto coordinate = [&] {
      return static_cast<std::int32_t>(dice.below(1U << 25)) - (1 << 24);
    };
    trace.vertices.emplace_back(coordinate(), coordinate(), dice.number());
  }
  for (std::uint32_t i = 1 + dice.below(10); i > 0; --i) {
    trace.planes.emplace_back(dice.number(), dice.number(), dice.number(), dice.number());
  }
}

/// \return  the first of `count` new indices
std::uint32_t add_indices(Dice& dice, Trace& trace, std::uint32_t count) {
  const auto first = static_cast<std::uint32_t>(trace.indices.size());
  for (; count > 0; --count) trace.indices.push_back(dice.below(trace.vertices.size()));
  return first;
}

void add_wedge(Dice& dice, Trace& trace) {
  const auto reference = [&] { return dice.below(2 * trace.planes.size()); };
  const auto index = static_cast<std::uint32_t>(trace.wedges.size());
  WedgeLinks links{dice.coin() ? fb::WedgeKind_linear : fb::WedgeKind_coverage,
                   static_cast<std::uint32_t>(trace.faces.size()),
                   dice.below(9),
                   kNone,
                   reference(),
                   dice.below(trace.header.casters.size())};
  for (std::uint32_t i = 0; i < links.face_count; ++i) {
    const std::uint32_t count = 3 + dice.below(6);
    const std::uint32_t first = add_indices(dice, trace, count);
    trace.faces.emplace_back(first, count, reference(), -1.0, dice.unit());
  }
  if (dice.coin()) {
    links.umbra = static_cast<std::uint32_t>(trace.umbra_polygons.size());
    const std::uint32_t count = 3 + dice.below(62);
    const std::uint32_t first = add_indices(dice, trace, count);
    trace.umbra_polygons.emplace_back(first, count, links.umbra_plane, index, links.caster,
                                      fb::UmbraRole_side, dice.unit(), 1.0);
  }
  std::array<std::uint32_t, 8> planes{};
  for (std::uint32_t& plane : planes) plane = reference();
  std::array<double, 6> factors{};
  for (double& factor : factors) factor = dice.number();
  trace.wedges.push_back(
      wedge(planes, static_cast<std::uint8_t>(4 + dice.below(5)), links, factors));
}

}  // namespace

Trace random_trace(std::uint64_t seed) {
  Dice dice(seed);
  Trace trace;
  trace.header = random_header(dice);
  if (dice.below(8) != 0) add_tables(dice, trace);
  if (!trace.vertices.empty()) {
    for (std::uint32_t i = dice.below(6); i > 0; --i) add_wedge(dice, trace);
  }
  const std::size_t pixels = std::size_t{trace.header.width} * trace.header.height;
  const bool expected = dice.coin(), sensitivity = dice.coin();
  for (std::size_t i = 0; i < pixels; ++i) {
    trace.depth.push_back(encode_depth(trace.header.depth_format, dice.unit()));
    if (expected) trace.expected_li.push_back(dice.number());
    if (sensitivity) trace.li_sensitivity.push_back(static_cast<float>(dice.unit()));
  }
  return trace;
}

}  // namespace wedgesim::traces
