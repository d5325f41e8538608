#include "functional/methods/occlusion_camera.h"

#include <tbb/parallel_for.h>

#include <array>
#include <glm/geometric.hpp>
#include <span>

#include "base/error.h"
#include "functional/geometry/silhouette.h"
#include "functional/methods/facing.h"
#include "functional/methods/occlusion_lookup.h"
#include "functional/methods/occlusion_pixels.h"
#include "functional/methods/stopwatch.h"
#include "functional/raster/light_window.h"
#include "functional/scene/light_file.h"

namespace wedgesim::functional {
namespace {

constexpr std::uint64_t kWordBytes = 4;   // a depth, a light intensity, the name of a strip
constexpr std::uint64_t kTexelBytes = 8;  // of a distortion map: name and distance

void check_outside(const Scene& scene, const Light& light) {
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) {
      if (glm::distance(p, light.centre) <= light.radius) {
        throw InputError(scene.place,
                         "caster '" + object.mesh.name + "' touches the light's sphere",
                         "casters outside the light");
      }
    }
  }
}

std::vector<Silhouette> find_silhouettes(const Scene& scene, const glm::dvec3& from) {
  std::vector<Silhouette> silhouettes(scene.objects.size());
  tbb::parallel_for(std::size_t{0}, silhouettes.size(), [&](std::size_t i) {
    if (scene.objects[i].casts) silhouettes[i] = find_silhouette(scene.objects[i].mesh, from);
  });
  return silhouettes;
}

Visibility render(const MethodInput& input, const MethodOptions& options) {
  const int size = options.integer("resolution", 1024, 128, 4096);
  const int maps = options.integer("maps", 2, 1, 2);
  OcclusionLookup::Options lookups;
  lookups.lookups = options.integer("lookups", 3, 1, 4);
  lookups.interpolate = options.choice<bool>("texels", {{"4", true}, {"1", false}});
  lookups.bias = options.number("bias", 2.0, 0.0, 100.0);
  options.check_all_known();

  const Scene& scene = input.scene;
  const Light light = reshaped({scene.light, {}}, LightShape::sphere);
  check_outside(scene, light);

  Visibility result;
  Stopwatch stopwatch(result);
  const std::vector<Silhouette> silhouettes = find_silhouettes(scene, light.centre);
  stopwatch.end("silhouettes");

  Window light_window;
  try {
    light_window = make_light_window(scene.objects, light.centre, light.radius, size);
  } catch (const InputError& error) {
    throw InputError(scene.place, error.what());
  }
  const ShadowMaps shadows = draw_shadow_maps(scene, silhouettes, light_window);
  stopwatch.end("shadow map");
  const std::vector<PenumbraStrip> strips =
      penumbra_strips(scene, light_window, silhouettes, shadows.surfaces, light.radius);
  const DistortionMap map(strips, size, maps);
  stopwatch.end("distortion maps");

  result.values.assign(input.depth.words.size(), 1.0F);
  const OcclusionLookup lookup(shadows, strips, map, focal_length(light_window), lookups);
  const std::vector<Facing> facing = find_facings(input, light.centre, light.radius);
  const OcclusionLookup::Count count =
      light_pixels(input, light_window, lookup, facing, result.values);
  stopwatch.end("pixels");

  MethodAccesses& accesses = result.accesses;
  accesses.z_reads = input.depth.words.size();
  accesses.li_writes = input.depth.words.size();
  accesses.map_reads = shadows.compared + map.compared() + count.depth_reads + count.map_reads;
  accesses.map_writes = shadows.compared + map.written();
  accesses.bytes =
      kWordBytes * (accesses.z_reads + accesses.li_writes + accesses.map_reads + shadows.compared) +
      kTexelBytes * map.written();
  return result;
}

constexpr std::array<std::string_view, 3> kCompared{
    "occlusion-camera", "occlusion-camera:resolution=512", "occlusion-camera:lookups=1"};
constexpr std::array<std::string_view, 3> kArtifacts{"crowded-distortion-map",
                                                     "overlapping-penumbrae", "false-shadows"};

}  // namespace

const Method kOcclusionCamera{
    .name = "occlusion-camera",
    .summary = "A shadow map whose rays bend round silhouettes",
    .source = "Soft shadow occlusion camera, 3.2",
    .options =
        "resolution=128…4096 (1024), maps=1…2 (2), lookups=1…4 (3), texels=1, 4 (4), "
        "bias=0…100 (2)",
    .compared = kCompared,
    .artifacts = kArtifacts,
    .render = render};

}  // namespace wedgesim::functional
