#include "functional/methods/silhouette_rings.h"

#include <tbb/parallel_for.h>

#include <array>
#include <glm/geometric.hpp>

#include "base/error.h"
#include "functional/geometry/extent.h"
#include "functional/geometry/plane_shadow.h"
#include "functional/geometry/ring_strips.h"
#include "functional/light/light_samples.h"
#include "functional/methods/plane_canvas.h"
#include "functional/methods/stopwatch.h"

namespace wedgesim::functional {
namespace {

// Where the shadow is about: the ray from the light through the middle of all casters.
glm::dvec3 middle_of_shadow(const Scene& scene, const ReceiverPlane& plane) {
  Bounds bounds;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) bounds.grow(p);
  }
  const glm::dvec3 middle = 0.5 * (bounds.low + bounds.high);
  const double light_height = plane.from_world(scene.light.centre).z;
  const double fall = light_height - plane.from_world(middle).z;
  if (!(fall > 0.0)) return plane.origin;
  return scene.light.centre + light_height / fall * (middle - scene.light.centre);
}

std::vector<glm::dvec3> choose_samples(const Scene& scene, const ReceiverPlane& plane, int count,
                                       SamplePattern pattern) {
  const Light& light = scene.light;
  if (light.shape == LightShape::sphere && plane.from_world(light.centre).z <= light.radius) {
    throw InputError(scene.place, "the plane of the receivers meets the light",
                     "the light on one side of it");
  }
  return light_samples(light, count, pattern, middle_of_shadow(scene, plane));
}

std::vector<PlaneCell> cells_of(const Rings& rings, const RingTriangles& triangles, bool flat) {
  std::vector<PlaneCell> cells;
  cells.reserve(rings.umbra.size() + triangles.strips.size() + triangles.mends.size());
  for (const Trapezoid& trapezoid : rings.umbra) cells.push_back(make_trapezoid(trapezoid, 1.0F));
  const auto add = [&](const ShadedTriangle& triangle) {
    const auto& c = triangle.corners;
    std::array<float, 3> intensity = triangle.intensity;
    if (flat)
      intensity.fill(static_cast<float>(triangle.hidden) / static_cast<float>(rings.samples));
    cells.push_back(make_triangle(
        {rings.vertices[c[0]], rings.vertices[c[1]], rings.vertices[c[2]]}, intensity));
  };
  for (const ShadedTriangle& triangle : triangles.strips) add(triangle);
  if (flat) return cells;
  for (const ShadedTriangle& triangle : triangles.mends) add(triangle);
  return cells;
}

Visibility render(const MethodInput& input, const MethodOptions& options) {
  const int count = options.integer("samples", 9, 1, 64);
  const auto pattern =
      options.choice<SamplePattern>("pattern", {{"random", SamplePattern::random},
                                                {"grid", SamplePattern::grid},
                                                {"border", SamplePattern::border}});
  const bool flat = options.choice<bool>("fill", {{"gouraud", false}, {"flat", true}});
  if (count == 1) options.refuse_without_effect({"pattern", "fill"}, "samples=2…64 with it");
  options.check_all_known();

  Visibility result;
  Stopwatch stopwatch(result);
  ReceiverPlane plane = find_receiver_plane(input.scene);
  const std::vector<glm::dvec3> samples = choose_samples(input.scene, plane, count, pattern);
  const PlaneShadow shadow(input.scene, plane, samples);
  std::vector<std::vector<GridSegment>> silhouettes(samples.size());
  tbb::parallel_for(std::size_t{0}, samples.size(),
                    [&](std::size_t i) { silhouettes[i] = shadow.silhouette(samples[i]); });
  stopwatch.end("silhouettes");
  const Rings rings = merge_silhouettes(silhouettes);
  stopwatch.end("rings");
  const RingTriangles triangles = triangulate_rings(rings);
  stopwatch.end("triangles");
  result.values.assign(input.depth.words.size(), 1.0F);
  draw_on_plane(input, plane, cells_of(rings, triangles, flat), result);
  stopwatch.end("pixels");
  return result;
}

constexpr std::array<std::string_view, 4> kCompared{"silhouette-rings-3", "silhouette-rings-9",
                                                    "silhouette-rings-16", "silhouette-rings-25"};
constexpr std::array<std::string_view, 4> kArtifacts{"ring-gradient", "too-narrow-penumbra",
                                                     "lost-thin-occluder", "grid-steps"};

}  // namespace

const Method kSilhouetteRings{
    .name = "silhouette-rings",
    .summary = "Silhouettes of light samples on one plane, merged into rings, triangles between",
    .source = "Seed 001, sections 3.1 to 3.3: triangulated soft shadows on a planar receiver",
    .options = "samples=1…64 (9), pattern=random|grid|border, fill=gouraud|flat",
    .compared = kCompared,
    .artifacts = kArtifacts,
    .render = render};

}  // namespace wedgesim::functional
