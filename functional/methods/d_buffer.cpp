#include "functional/methods/d_buffer.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <numeric>

#include "base/error.h"
#include "functional/geometry/extent.h"
#include "functional/methods/d_buffer_map.h"
#include "functional/methods/stopwatch.h"

namespace wedgesim::functional {
namespace {

enum class Falloff { smooth, sqrt, exact };
enum class Parameter { derived, printed };

struct PixelOptions {
  Falloff falloff = Falloff::smooth;
  Parameter parameter = Parameter::derived;
  bool bilinear = false;
};

// How far x at distance d is through the penumbra of an edge at |cx_s| from where its volume's side
// is crossed at `crossed`: 0 there, 1/2 at the plane through the centre and the edge.
double through(double d, double crossed, double edge, Parameter parameter) {
  const double beyond = parameter == Parameter::derived ? d - edge : crossed - edge;
  return edge * (d - crossed) / (2.0 * crossed * beyond);
}

// The visible part of the disk beside a straight edge that leaves the part t of its diameter.
float visible_part(double t, Falloff falloff) {
  switch (falloff) {
    case Falloff::smooth:
      return static_cast<float>((3.0 - 2.0 * t) * t * t);
    case Falloff::sqrt:
      return static_cast<float>(std::sqrt(t));
    case Falloff::exact:
      break;
  }
  const double s = 1.0 - 2.0 * t;  // the edge's distance from the centre, radii
  return static_cast<float>((std::acos(s) - s * std::sqrt(1.0 - s * s)) / M_PI);
}

class Pixels {
 public:
  Pixels(const MethodInput& input, const LightDisk& disk, const DBuffer& map,
         const PixelOptions& options)
      : input_(input), map_(map), options_(options), rays_(map.view) {
    for (const Object& object : input.scene.objects) {
      for (const auto& t : object.mesh.triangles) {
        const auto& p = object.mesh.positions;
        const bool away = disk_facing(disk, {p[t[0]], p[t[1]], p[t[2]]}) < DiskFacing::front_belt;
        unlit_.push_back(object.casts && away);
      }
    }
  }

  // Visibility at texel (x, y) of a point at distance d; 1 outside the map.
  float at_texel(int x, int y, double d, bool unlit) const {
    if (x < 0 || y < 0 || x >= map_.width || y >= map_.width) return 1.0F;
    const auto texel = static_cast<std::size_t>(y) * static_cast<std::size_t>(map_.width) +
                       static_cast<std::size_t>(x);
    const double umbra = map_.umbra[texel];
    const Parameter parameter = options_.parameter;
    if (umbra > 0.0 && (unlit || d > map_.occluder[texel])) {
      if (!(d > umbra)) return 0.0F;
      const double t = through(d, umbra, map_.umbra_edge[texel], parameter);
      return visible_part(std::clamp(t, 0.0, 1.0), options_.falloff);
    }
    const double penumbra = map_.penumbra[texel];
    if (!(d > penumbra)) return 1.0F;
    const auto& edges = map_.penumbra_edge.empty() ? map_.umbra_edge : map_.penumbra_edge;
    const double t = 1.0 - through(d, penumbra, edges[texel], parameter);
    return visible_part(std::clamp(t, 0.0, 1.0), options_.falloff);
  }

  // Visibility of a pixel that is not sky, and how many texels were looked up.
  float at_pixel(int x, int y, std::size_t pixel, std::uint64_t& lookups) const {
    const double z = traces::decode_depth(input_.depth.format, input_.depth.words[pixel]);
    const MapPlace place = place_in(map_.view, world_point(input_.window, x + 0.5, y + 0.5, z));
    if (!(place.w > 0.0) || !(place.x > -1.0 && place.y > -1.0) ||
        !(place.x < map_.width + 1.0 && place.y < map_.width + 1.0)) {
      return 1.0F;
    }
    const double d = place.w * rays_.length(place.x, place.y);
    const bool unlit = unlit_[input_.depth.triangle[pixel]];
    if (!options_.bilinear) {
      ++lookups;
      return at_texel(static_cast<int>(std::floor(place.x)), static_cast<int>(std::floor(place.y)),
                      d, unlit);
    }
    lookups += 4;
    const double left = std::floor(place.x - 0.5);
    const double top = std::floor(place.y - 0.5);
    const auto fx = static_cast<float>(place.x - 0.5 - left);
    const auto fy = static_cast<float>(place.y - 0.5 - top);
    const int ix = static_cast<int>(left);
    const int iy = static_cast<int>(top);
    const float upper =
        (1.0F - fx) * at_texel(ix, iy, d, unlit) + fx * at_texel(ix + 1, iy, d, unlit);
    const float lower =
        (1.0F - fx) * at_texel(ix, iy + 1, d, unlit) + fx * at_texel(ix + 1, iy + 1, d, unlit);
    return (1.0F - fy) * upper + fy * lower;
  }

  // \return texels looked up
  std::uint64_t render(std::vector<float>& values) const {
    const auto width = static_cast<std::size_t>(input_.window.width);
    std::vector<std::uint64_t> lookups(static_cast<std::size_t>(input_.window.height), 0);
    tbb::parallel_for(0, input_.window.height, [&](int y) {
      const std::size_t row = static_cast<std::size_t>(y) * width;
      for (int x = 0; x < input_.window.width; ++x) {
        const std::size_t pixel = row + static_cast<std::size_t>(x);
        if (input_.depth.triangle[pixel] == DepthBuffer::kSky) continue;
        values[pixel] = at_pixel(x, y, pixel, lookups[static_cast<std::size_t>(y)]);
      }
    });
    return std::accumulate(lookups.begin(), lookups.end(), std::uint64_t{0});
  }

 private:
  const MethodInput& input_;
  const DBuffer& map_;
  PixelOptions options_;
  MapRays rays_;
  std::vector<bool> unlit_;  // of each triangle of the scene: a caster's, the centre behind it
};

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
  PixelOptions pixel_options;
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
      map.width == 0 ? 0 : Pixels(input, disk, map, pixel_options).render(result.values);
  stopwatch.end("pixels");
  MethodAccesses& accesses = result.accesses;
  accesses.z_reads = result.values.size();
  accesses.li_writes = result.values.size();
  accesses.map_reads = map.tests + lookups;
  accesses.map_writes = map.writes;
  const std::uint64_t texel_bytes = map_options.two_edges ? 20 : 16;
  accesses.bytes =
      4 * (accesses.z_reads + accesses.li_writes + map.tests + map.writes) + texel_bytes * lookups;
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
