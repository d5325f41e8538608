#include "functional/methods/frame.h"

#include <glm/vector_relational.hpp>

#include "base/error.h"
#include "functional/light/coverage.h"
#include "functional/methods/light_intensity.h"
#include "functional/methods/volumes.h"
#include "functional/scene/origin.h"

namespace wedgesim::functional {
namespace {

namespace fb = traces::fb;

fb::Vec3 to_fb(const glm::dvec3& v) { return {v.x, v.y, v.z}; }

fb::Matrix4 to_fb(const glm::dmat4& m) {
  std::array<double, 16> columns{};
  for (int c = 0; c < 4; ++c) {
    for (int r = 0; r < 4; ++r) columns[static_cast<std::size_t>(4 * c + r)] = m[c][r];
  }
  return fb::Matrix4(columns);
}

fb::LightShape to_fb(LightShape shape) {
  switch (shape) {
    case LightShape::point:
      return fb::LightShape_point;
    case LightShape::rectangle:
      return fb::LightShape_rectangle;
    case LightShape::sphere:
      return fb::LightShape_sphere;
  }
  return fb::LightShape_point;
}

void fill_header(const Scene& scene, const Window& window, traces::Header& header) {
  header.name = scene.name;
  header.width = static_cast<std::uint32_t>(window.width);
  header.height = static_cast<std::uint32_t>(window.height);
  header.camera.eye = to_fb(window.eye);
  for (std::size_t i = 0; i < 4; ++i) {
    header.camera.near_rectangle[i] = to_fb(window.near_rectangle[i]);
  }
  header.camera.window_from_world = to_fb(window.window_from_world);
  header.camera.world_from_window = to_fb(window.world_from_window);
  traces::Light light;
  light.shape = to_fb(scene.light.shape);
  light.centre = to_fb(scene.light.centre);
  light.half_u = to_fb(scene.light.half_u);
  light.half_v = to_fb(scene.light.half_v);
  light.radius = scene.light.radius;
  light.colour = to_fb(scene.light.colour);
  header.lights.push_back(std::move(light));
}

// A point this near to the bounds of the objects, of their diagonal, is one of theirs: stored depth
// is rounded. Volumes end farther out (extent.cpp).
constexpr double kOfTheObjects = 1e-3;

Bounds receivers_of(const Scene& scene, const Window& window, const DepthBuffer& depth,
                    const FrameOptions& options) {
  const Bounds objects = bounds_of(scene.objects);
  if (options.depth == nullptr) return objects;
  const glm::dvec3 near(kOfTheObjects * objects.diagonal());
  Bounds all = objects;
  const std::uint32_t sky = traces::sky_word(depth.format);
  for (std::size_t i = 0; i < depth.words.size(); ++i) {
    if (depth.words[i] == sky) continue;
    const auto width = static_cast<std::size_t>(window.width);
    const glm::dvec3 p = world_point(window, static_cast<double>(i % width) + 0.5,
                                     static_cast<double>(i / width) + 0.5,
                                     traces::decode_depth(depth.format, depth.words[i]));
    const bool outside = glm::any(glm::lessThan(p, objects.low - near)) ||
                         glm::any(glm::greaterThan(p, objects.high + near));
    if (outside) all.grow(p);
  }
  return all;
}

// All but the header's world coordinates and matrices, for a scene taken from a good origin.
void fill_frame(const Scene& scene, const FrameOptions& options, Frame& frame) {
  const Window window = make_window(scene.camera, scene.width, scene.height);
  frame.depth = options.depth != nullptr
                    ? *options.depth
                    : render_depth(window, scene.objects, options.depth_format);
  traces::Header& header = frame.trace.header;
  header.depth_format = frame.depth.format;
  const glm::dmat3 light_axes(light_from_world(scene.light));
  header.lights.front().light_from_window =
      to_fb(from_window(window, light_axes, light_axes * (window.eye - scene.light.centre)));
  frame.receivers = receivers_of(scene, window, frame.depth, options);
  frame.length = options.length;
  frame.depth_given = options.depth != nullptr;
  frame.geometry = build_shadow_geometry(scene, window, options.kind, options.length,
                                         frame.receivers, frame.trace);
  frame.trace.depth = frame.depth.words;

  const fb::ZMethod method =
      options.z_method.value_or(header.z_fail_needed ? fb::ZMethod_fail : fb::ZMethod_pass);
  if (header.z_fail_needed && method == fb::ZMethod_pass) {
    refuse_z_pass(scene.place);
  }
  header.expected_z_method = method;
  if (!options.expected_li) return;
  LightIntensity light =
      evaluate_light_intensity(scene, window, frame.depth, frame.geometry, frame.trace, method);
  frame.trace.expected_li = std::move(light.li);
  frame.trace.li_sensitivity = std::move(light.sensitivity);
}

}  // namespace

Frame make_frame(const Scene& scene, const FrameOptions& options) {
  if (scene.light.shape != LightShape::point && !has_extent(scene.light)) {
    throw InputError(scene.place, "the light has no extent", "a point light");
  }
  Frame frame;
  frame.window = make_window(scene.camera, scene.width, scene.height);
  fill_header(scene, frame.window, frame.trace.header);
  frame.origin = best_origin(scene);
  if (frame.origin == glm::dvec3(0.0)) {
    fill_frame(scene, options, frame);
  } else {
    fill_frame(taken_from(scene, frame.origin), options, frame);
  }
  return frame;
}

}  // namespace wedgesim::functional
