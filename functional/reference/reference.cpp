#include "functional/reference/reference.h"

#include <embree3/rtcore.h>
#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>
#include <glm/vec2.hpp>
#include <limits>
#include <memory>

#include "base/check.h"
#include "functional/light/unit_disc.h"
#include "functional/scene/across.h"
#include "functional/scene/light_texture.h"

namespace wedgesim::functional {
namespace {

struct Release {
  void operator()(RTCDevice device) const { rtcReleaseDevice(device); }
  void operator()(RTCScene scene) const { rtcReleaseScene(scene); }
};
using Device = std::unique_ptr<std::remove_pointer_t<RTCDevice>, Release>;
using CasterScene = std::unique_ptr<std::remove_pointer_t<RTCScene>, Release>;

CasterScene build_casters(RTCDevice device, const Scene& scene) {
  CasterScene casters(rtcNewScene(device));
  rtcSetSceneFlags(casters.get(), RTC_SCENE_FLAG_ROBUST);
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    const Mesh& mesh = object.mesh;
    RTCGeometry geometry = rtcNewGeometry(device, RTC_GEOMETRY_TYPE_TRIANGLE);
    auto* vertices = static_cast<float*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_VERTEX, 0, RTC_FORMAT_FLOAT3,
                                3 * sizeof(float), mesh.positions.size()));
    auto* indices = static_cast<std::uint32_t*>(
        rtcSetNewGeometryBuffer(geometry, RTC_BUFFER_TYPE_INDEX, 0, RTC_FORMAT_UINT3,
                                3 * sizeof(std::uint32_t), mesh.triangles.size()));
    for (const glm::dvec3& p : mesh.positions) {
      for (int i = 0; i < 3; ++i) *vertices++ = static_cast<float>(p[i]);
    }
    for (const auto& t : mesh.triangles) indices = std::copy(t.begin(), t.end(), indices);
    rtcCommitGeometry(geometry);
    rtcAttachGeometry(casters.get(), geometry);
    rtcReleaseGeometry(geometry);
  }
  rtcCommitScene(casters.get());
  return casters;
}

// splitmix64: one well-mixed word for each input.
std::uint64_t mix(std::uint64_t x) {
  x += 0x9e3779b97f4a7c15U;
  x = (x ^ (x >> 30U)) * 0xbf58476d1ce4e5b9U;
  x = (x ^ (x >> 27U)) * 0x94d049bb133111ebU;
  return x ^ (x >> 31U);
}

// The light as a point sees it: centre and two half axes of a rectangle or a disc.
struct Aperture {
  glm::dvec3 centre, u, v;
  bool disc = false;
};

Aperture aperture_from(const Light& light, const glm::dvec3& p) {
  if (light.shape == LightShape::rectangle) {
    return {light.centre, light.half_u, light.half_v, false};
  }
  const glm::dvec3 way = light.centre - p;
  const double distance = glm::length(way);
  const glm::dvec3 axis = way / distance;
  double radius = 0.0;
  if (light.shape == LightShape::sphere && distance > light.radius) {
    radius = light.radius * distance / std::sqrt(distance * distance - light.radius * light.radius);
  }
  const auto [u, v] = Across(axis);
  return {light.centre, radius * u, radius * v, true};
}

// The cells of a light that are sampled once each, and what of the light's power each stands for.
class Cells {
 public:
  Cells(const Light& light, int samples) {
    const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(samples) + 0.5)));
    columns_ = rows_ = side;
    if (!light.texture) return;
    shares_ = emission_shares(*light.texture);
    columns_ = (side + shares_.width - 1) / shares_.width * shares_.width;
    rows_ = (side + shares_.height - 1) / shares_.height * shares_.height;
    for (int cell = 0; cell < count(); ++cell) add(cell, whole_);
  }
  int columns() const { return columns_; }
  int rows() const { return rows_; }
  int count() const { return columns_ * rows_; }
  std::size_t channels() const { return shares_.values.empty() ? 1 : 3; }
  bool is_black(int cell) const {
    if (shares_.values.empty()) return false;
    const float* texel = texel_of(cell);
    return texel[0] == 0.0F && texel[1] == 0.0F && texel[2] == 0.0F;
  }
  /// Adds what a cell emits of each colour.
  void add(int cell, std::array<double, 3>& sum) const {
    if (shares_.values.empty()) {
      sum[0] += 1.0;
      return;
    }
    for (std::size_t c = 0; c < 3; ++c) sum[c] += static_cast<double>(texel_of(cell)[c]);
  }
  /// What is left of a colour without some cells, added in order: 0 without all of them.
  float left(const std::array<double, 3>& hidden, std::size_t channel) const {
    const double whole = shares_.values.empty() ? count() : whole_[channel];
    return static_cast<float>(1.0 - hidden[channel] / whole);
  }

 private:
  const float* texel_of(int cell) const {
    return shares_.pixel(cell % columns_ * shares_.width / columns_,
                         cell / columns_ * shares_.height / rows_);
  }

  int columns_ = 1, rows_ = 1;
  Image shares_;  // of a textured light; else empty
  std::array<double, 3> whole_{};
};

// How far rays start from a caster, in distances of what is seen: a few roundings of float.
constexpr double kOffSurface = 0x1p-20;

}  // namespace

std::vector<float> reference_visibility(const Scene& scene, const Window& window,
                                        const DepthBuffer& depth, int samples, std::uint64_t seed,
                                        std::span<const std::uint8_t> wanted) {
  CHECK_GE(samples, 1);
  // No number of threads: it would hold for all of the process.
  const Device device(rtcNewDevice(nullptr));
  WEDGESIM_CHECK(device != nullptr);
  const CasterScene casters = build_casters(device.get(), scene);
  const Cells cells(scene.light, samples);
  std::vector<float> visibility(depth.words.size() * cells.channels(), 1.0F);
  const double eye_to_light = glm::length(scene.camera.eye - scene.light.centre);

  tbb::parallel_for(0, window.height, [&](int y) {
    for (int x = 0; x < window.width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
          static_cast<std::size_t>(x);
      if (depth.triangle[pixel] == DepthBuffer::kSky) continue;
      if (!wanted.empty() && wanted[pixel] == 0) continue;
      const double z = traces::decode_depth(depth.format, depth.words[pixel]);
      glm::dvec3 p = world_point(window, x + 0.5, y + 0.5, z);
      const DepthBuffer::Surface surface = depth.surface(pixel);
      const Object& object = scene.objects[surface.object];
      const auto& corner = object.mesh.triangles[surface.triangle];
      const glm::dvec3& a = object.mesh.positions[corner[0]];
      glm::dvec3 normal = glm::normalize(
          glm::cross(object.mesh.positions[corner[1]] - a, object.mesh.positions[corner[2]] - a));
      if (glm::dot(normal, window.eye - p) < 0.0) normal = -normal;
      glm::dvec3 origin = p;
      if (object.casts) {
        // On the triangle, whatever the stored depth rounds, and off it by more than rays round.
        p -= glm::dot(p - a, normal) * normal;
        origin = p + kOffSurface * (glm::length(p) + eye_to_light) * normal;
      }
      const Aperture light = aperture_from(scene.light, p);

      std::array<double, 3> hidden{};
      for (int k = 0; k < cells.count(); k += 8) {
        alignas(32) std::array<int, 8> valid{};
        RTCRay8 rays = {};
        for (int lane = 0; lane < 8 && k + lane < cells.count(); ++lane) {
          const int cell = k + lane;
          if (cells.is_black(cell)) continue;
          const std::uint64_t random =
              mix(seed ^ mix(pixel * static_cast<std::uint64_t>(cells.count()) +
                             static_cast<std::uint64_t>(cell)));
          const double jitter_x = static_cast<double>(random >> 32U) / 4294967296.0;
          const double jitter_y = static_cast<double>(random & 0xffffffffU) / 4294967296.0;
          glm::dvec2 s(2.0 * (cell % cells.columns() + jitter_x) / cells.columns() - 1.0,
                       2.0 * (cell / cells.columns() + jitter_y) / cells.rows() - 1.0);
          if (light.disc) s = to_disc(s);
          const glm::dvec3 way = light.centre + s.x * light.u + s.y * light.v - origin;
          if (object.casts && glm::dot(way, normal) <= 0.0) {  // into what is closed
            cells.add(cell, hidden);
            continue;
          }
          valid[static_cast<std::size_t>(lane)] = -1;
          rays.org_x[lane] = static_cast<float>(origin.x);
          rays.org_y[lane] = static_cast<float>(origin.y);
          rays.org_z[lane] = static_cast<float>(origin.z);
          rays.dir_x[lane] = static_cast<float>(way.x);
          rays.dir_y[lane] = static_cast<float>(way.y);
          rays.dir_z[lane] = static_cast<float>(way.z);
          rays.tnear[lane] = 0.0F;
          rays.tfar[lane] = 1.0F;
          rays.mask[lane] = 0xffffffffU;
        }
        RTCIntersectContext context;
        rtcInitIntersectContext(&context);
        rtcOccluded8(valid.data(), casters.get(), &context, &rays);
        for (std::size_t lane = 0; lane < 8; ++lane) {
          if (valid[lane] == 0 || !(rays.tfar[lane] < 0.0F)) continue;
          cells.add(k + static_cast<int>(lane), hidden);
        }
      }
      for (std::size_t c = 0; c < cells.channels(); ++c) {
        visibility[pixel * cells.channels() + c] = cells.left(hidden, c);
      }
    }
  });
  return visibility;
}

}  // namespace wedgesim::functional
