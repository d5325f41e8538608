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

}  // namespace

std::vector<float> reference_visibility(const Scene& scene, const Window& window,
                                        const DepthBuffer& depth, int samples, std::uint64_t seed,
                                        std::span<const std::uint8_t> wanted) {
  CHECK_GE(samples, 1);
  const Device device(rtcNewDevice("threads=1"));
  WEDGESIM_CHECK(device != nullptr);
  const CasterScene casters = build_casters(device.get(), scene);
  const int side = std::max(1, static_cast<int>(std::sqrt(static_cast<double>(samples) + 0.5)));
  std::vector<float> visibility(depth.words.size(), 1.0F);
  const double scene_size = glm::length(scene.camera.eye - scene.light.centre);

  tbb::parallel_for(0, window.height, [&](int y) {
    for (int x = 0; x < window.width; ++x) {
      const std::size_t pixel =
          static_cast<std::size_t>(y) * static_cast<std::size_t>(window.width) +
          static_cast<std::size_t>(x);
      if (depth.triangle[pixel] == DepthBuffer::kSky) continue;
      if (!wanted.empty() && wanted[pixel] == 0) continue;
      const double z = traces::decode_depth(depth.format, depth.words[pixel]);
      const glm::dvec3 p = world_point(window, x + 0.5, y + 0.5, z);
      // Off the surface, by more than the rounding of the stored depth.
      const DepthBuffer::Surface surface = depth.surface(pixel);
      const Object& object = scene.objects[surface.object];
      const auto& corner = object.mesh.triangles[surface.triangle];
      const glm::dvec3& a = object.mesh.positions[corner[0]];
      glm::dvec3 normal = glm::normalize(
          glm::cross(object.mesh.positions[corner[1]] - a, object.mesh.positions[corner[2]] - a));
      if (glm::dot(normal, window.eye - p) < 0.0) normal = -normal;
      const glm::dvec3 origin = p + (object.casts ? 1e-4 * scene_size : 0.0) * normal;
      const Aperture light = aperture_from(scene.light, p);

      int hidden = 0;
      for (int k = 0; k < side * side; k += 8) {
        alignas(32) std::array<int, 8> valid{};
        RTCRay8 rays = {};
        for (int lane = 0; lane < 8 && k + lane < side * side; ++lane) {
          const int cell = k + lane;
          const std::uint64_t random =
              mix(seed ^ mix(pixel * static_cast<std::uint64_t>(side * side) +
                             static_cast<std::uint64_t>(cell)));
          const double jitter_x = static_cast<double>(random >> 32U) / 4294967296.0;
          const double jitter_y = static_cast<double>(random & 0xffffffffU) / 4294967296.0;
          glm::dvec2 s(2.0 * (cell % side + jitter_x) / side - 1.0,
                       2.0 * (cell / side + jitter_y) / side - 1.0);
          if (light.disc) s = to_disc(s);
          const glm::dvec3 way = light.centre + s.x * light.u + s.y * light.v - origin;
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
          if (valid[lane] != 0 && rays.tfar[lane] < 0.0F) ++hidden;
        }
      }
      visibility[pixel] = 1.0F - static_cast<float>(hidden) / static_cast<float>(side * side);
    }
  });
  return visibility;
}

}  // namespace wedgesim::functional
