#include "functional/methods/d_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <limits>

#include "base/error.h"
#include "functional/geometry/extent.h"
#include "functional/methods/d_buffer_map.h"
#include "functional/methods/d_buffer_pixels.h"
#include "functional/methods/facing.h"
#include "functional/methods/stopwatch.h"

namespace wedgesim::functional {
namespace {

using Falloff = DBufferPixels::Falloff;
using Parameter = DBufferPixels::Parameter;

// \return the height above the disk of the farthest vertex of the scene
double check_heights(const Scene& scene, const LightDisk& disk) {
  double least = std::numeric_limits<double>::infinity();
  double most = 0.0;
  for (const Object& object : scene.objects) {
    for (const glm::dvec3& p : object.mesh.positions) {
      most = std::max(most, disk.height(p));
      if (object.casts) least = std::min(least, disk.height(p));
    }
  }
  if (!(least > 1e-6 * most)) {
    throw InputError(scene.place, "a caster reaches the plane of the light's disk",
                     "casters wholly in front of it for the method d-buffer");
  }
  return most;
}

Visibility render(const MethodInput& input, const MethodOptions& options) {
  DBufferOptions map_options;
  map_options.resolution = options.integer("resolution", 1024, 128, 4096);
  map_options.crossing = options.choice<Crossing>("crossing", {{"caster", Crossing::by_caster},
                                                               {"farthest", Crossing::farthest},
                                                               {"nearest", Crossing::nearest}});
  map_options.distances = options.choice<Distances>(
      "distances", {{"exact", Distances::exact}, {"interpolated", Distances::interpolated}});
  map_options.two_edges = options.integer("channels", 4, 4, 5) == 5;
  DBufferPixels pixel_options;
  pixel_options.falloff = options.choice<Falloff>(
      "falloff", {{"smooth", Falloff::smooth}, {"sqrt", Falloff::sqrt}, {"exact", Falloff::exact}});
  pixel_options.parameter = options.choice<Parameter>(
      "parameter", {{"derived", Parameter::derived}, {"printed", Parameter::printed}});
  pixel_options.bilinear = options.choice<bool>("lookup", {{"nearest", false}, {"bilinear", true}});
  options.check_all_known();
  const Scene& scene = input.scene;
  if (!has_extent(scene.light)) {
    throw InputError(scene.place, "the light has no extent",
                     "a rectangle or a sphere for the method d-buffer");
  }

  Visibility result;
  Stopwatch stopwatch(result);
  std::vector<const Mesh*> casters;
  Bounds bounds;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    casters.push_back(&object.mesh);
    for (const glm::dvec3& p : object.mesh.positions) bounds.grow(p);
  }
  const LightDisk disk = disk_of(scene.light, 0.5 * (bounds.low + bounds.high));
  const double end_height = 1.001 * check_heights(scene, disk);
  std::vector<DiskSilhouettes> silhouettes(casters.size());
  tbb::parallel_for(std::size_t{0}, casters.size(), [&](std::size_t i) {
    silhouettes[i] = find_disk_silhouettes(disk, *casters[i]);
  });
  stopwatch.end("silhouettes");
  std::vector<DiskVolumes> volumes(casters.size());
  tbb::parallel_for(std::size_t{0}, casters.size(), [&](std::size_t i) {
    volumes[i] = extrude_disk_volumes(disk, *casters[i], silhouettes[i], end_height);
  });
  stopwatch.end("volumes");
  const DBuffer map = draw_d_buffer(scene, disk, silhouettes, volumes, map_options);
  stopwatch.end("maps");

  result.values.assign(input.depth.words.size(), 1.0F);
  const std::uint64_t lookups =
      map.width == 0 ? 0
                     : look_up_pixels(input, map, find_facings(input, disk.centre, disk.radius),
                                      pixel_options, result.values);
  stopwatch.end("pixels");
  MethodAccesses& accesses = result.accesses;
  accesses.z_reads = result.values.size();
  accesses.li_writes = result.values.size();
  accesses.map_reads = map.count.tests + lookups;
  accesses.map_writes = map.count.writes;
  const std::uint64_t texel_bytes = map_options.two_edges ? 20 : 16;
  accesses.bytes =
      4 * (accesses.z_reads + accesses.li_writes + map.count.tests + map.count.writes) +
      texel_bytes * lookups;
  return result;
}

constexpr std::array<std::string_view, 4> kCompared{"d-buffer", "d-buffer:resolution=512",
                                                    "d-buffer:resolution=2048,lookup=bilinear",
                                                    "d-buffer:falloff=sqrt"};
constexpr std::array<std::string_view, 4> kArtifacts{"too-dark-small-occluder", "concave-occluder",
                                                     "acute-corner", "map-resolution"};

}  // namespace

const Method kDBuffer{
    .name = "d-buffer",
    .summary = "Distances to the umbra and penumbra volumes of a disk light, in a map seen from it",
    .source = "Jakobsen et al. 2004 (seed 002), sections 2 to 4",
    .options =
        "resolution=128…4096 (1024), lookup=nearest|bilinear, falloff=smooth|sqrt|exact, "
        "parameter=derived|printed, crossing=caster|farthest|nearest, "
        "distances=exact|interpolated, channels=4|5",
    .compared = kCompared,
    .artifacts = kArtifacts,
    .render = render};

}  // namespace wedgesim::functional
