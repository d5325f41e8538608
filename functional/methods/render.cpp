#include "functional/methods/render.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <glm/geometric.hpp>
#include <span>

#include "base/check.h"
#include "functional/scene/light_texture.h"
#include "functional/scene/lights.h"

namespace wedgesim::functional {
namespace {

constexpr glm::dvec3 kSky{0.47, 0.60, 0.76};       // linear colour behind everything
constexpr glm::dvec3 kSkyLight{0.18, 0.21, 0.26};  // on a surface that faces straight up
constexpr glm::dvec3 kGroundLight{0.08, 0.075, 0.07};
constexpr double kDirect = 0.85;  // of the light at full visibility

// Of a triangle, towards the eye: receivers may be seen from either side.
glm::dvec3 normal_to(const Mesh& mesh, std::size_t triangle, const glm::dvec3& eye) {
  const auto& corner = mesh.triangles[triangle];
  const glm::dvec3& a = mesh.positions[corner[0]];
  const glm::dvec3 n = glm::cross(mesh.positions[corner[1]] - a, mesh.positions[corner[2]] - a);
  const double length = glm::length(n);
  if (length == 0.0) return glm::dvec3(0.0);
  return glm::dot(n, eye - a) < 0.0 ? n / -length : n / length;
}

// One light and how much of it each pixel sees.
struct Lit {
  Lit(const Light& l, std::span<const float> v, int c)
      : centre(l.centre), power(light_power(l)), visibility(v), channels(c) {}
  glm::dvec3 centre, power;
  std::span<const float> visibility;  // (height, width, channels)
  int channels;

  /// What the light's centre gives to a point of reflectance 1.
  glm::dvec3 illuminate(std::size_t pixel, const glm::dvec3& point,
                        const glm::dvec3& normal) const {
    const double cosine = std::max(0.0, glm::dot(normal, glm::normalize(centre - point)));
    glm::dvec3 light;
    for (int c = 0; c < 3; ++c) {
      const auto i = pixel * static_cast<std::size_t>(channels) +
                     static_cast<std::size_t>(std::min(c, channels - 1));
      const double direct = cosine * std::clamp(static_cast<double>(visibility[i]), 0.0, 1.0);
      light[c] = kDirect * direct * power[c];
    }
    return light;
  }
};

glm::dvec3 sky_light(const Scene& scene, const glm::dvec3& normal) {
  const double up = 0.5 + 0.5 * glm::dot(normal, glm::normalize(scene.camera.up));
  return glm::mix(kGroundLight, kSkyLight, up);
}

Image shade(const Scene& scene, const Window& window, const DepthBuffer& depth,
            std::span<const Lit> lights) {
  Image image(window.width, window.height, 3);
  for (const Lit& lit : lights) {
    CHECK_EQ(lit.visibility.size(), depth.words.size() * static_cast<std::size_t>(lit.channels));
  }
  tbb::parallel_for(0, window.height, [&](int y) {
    for (int x = 0; x < window.width; ++x) {
      const auto pixel = static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
                         static_cast<std::size_t>(x);
      glm::dvec3 colour = kSky;
      if (depth.triangle[pixel] != DepthBuffer::kSky) {
        const DepthBuffer::Surface surface = depth.surface(pixel);
        const Object& object = scene.objects[surface.object];
        const double z = traces::decode_depth(depth.format, depth.words[pixel]);
        const glm::dvec3 point = world_point(window, x + 0.5, y + 0.5, z);
        const glm::dvec3 normal = normal_to(object.mesh, surface.triangle, window.eye);
        glm::dvec3 light = sky_light(scene, normal);
        for (const Lit& lit : lights) light += lit.illuminate(pixel, point, normal);
        colour = object.colour * light;
      }
      for (int c = 0; c < 3; ++c) {
        image.pixel(x, y)[c] = static_cast<float>(std::clamp(colour[c], 0.0, 1.0));
      }
    }
  });
  return image;
}

}  // namespace

View render_view(const Scene& scene, const MethodChoice& choice, traces::fb::DepthFormat format) {
  View view;
  view.window = make_window(scene.camera, scene.width, scene.height);
  view.depth = render_depth(view.window, scene.objects, format);
  const auto visibility_of = [&](std::size_t i) {
    return render_method({with_light(scene, i), view.window, view.depth}, choice);
  };
  view.visibility = visibility_of(0);
  for (std::size_t i = 1; i < light_count(scene); ++i) {
    view.other_visibility.push_back(visibility_of(i));
  }
  return view;
}

Image shade(const Scene& scene, const View& view) {
  CHECK_EQ(1 + view.other_visibility.size(), light_count(scene));
  std::vector<Lit> lights;
  for (std::size_t i = 0; i < light_count(scene); ++i) {
    const Visibility& seen = i == 0 ? view.visibility : view.other_visibility[i - 1];
    lights.emplace_back(light_at(scene, i), seen.values, seen.channels);
  }
  return shade(scene, view.window, view.depth, lights);
}

Image shade(const Scene& scene, const Window& window, const DepthBuffer& depth,
            const std::vector<float>& visibility) {
  const Lit lit(scene.light, visibility, visibility.size() == depth.words.size() ? 1 : 3);
  return shade(scene, window, depth, std::span(&lit, 1));
}

Image encode_srgb(const Image& linear) {
  Image encoded = linear;
  for (float& value : encoded.values) {
    const float v = std::clamp(value, 0.0F, 1.0F);
    value = v <= 0.0031308F ? 12.92F * v : 1.055F * std::pow(v, 1.0F / 2.4F) - 0.055F;
  }
  return encoded;
}

}  // namespace wedgesim::functional
