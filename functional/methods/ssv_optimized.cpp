#include "functional/methods/ssv_optimized.h"

#include <algorithm>
#include <array>

#include "base/error.h"
#include "functional/light/light_cells.h"
#include "functional/methods/shader_kernel.h"
#include "functional/methods/ssv_kernel.h"
#include "functional/methods/volume_pass.h"

namespace wedgesim::functional {
namespace {

VolumeOptions read_volume_options(const MethodOptions& options) {
  return {
      .volumes = {.z = read_z(options),
                  .tight_wedges =
                      options.choice<bool>("wedges", {{"tight", true}, {"loose", false}}),
                  .in_halves =
                      options.choice<bool>("halves", {{"pixel", false}, {"polygons", true}}),
                  .by_groups = options.choice<bool>("overlap", {{"sum", false}, {"loops", true}})},
      .cull = options.choice<bool>("cull", {{"tiles", true}, {"none", false}})};
}

enum class Words { float32, split };

struct Shading {
  bool tables = false;  // the shader's table lookups (shader_tables.h) for exact clipping
  Words words = Words::float32;
};

DrawRow make_kernel(const Light& light, const Shading& shading) {
  if (light.shape == LightShape::point) return hard_kernel();
  if (shading.words == Words::split) return split_kernel(light.shape, shading.tables);
  return shading.tables ? table_kernel(light.shape) : coverage_kernel(light.shape);
}

void refuse_what_is_not_treated(const Scene& scene, const VolumeOptions& volumes,
                                const Shading& shading, int split) {
  if (split > 1 && scene.light.shape != LightShape::rectangle) {
    throw InputError(scene.place, "only a rectangular light can be split", "split=1");
  }
  if (shading.words == Words::split && volumes.volumes.by_groups) {
    throw InputError(scene.place, "the overlap heuristic merges whole words", "vbuffer=float");
  }
}

Visibility render(const MethodInput& input, const MethodOptions& options) {
  VolumeOptions volumes = read_volume_options(options);
  const int split = options.integer("split", 1, 1, 4);
  const Shading shading{
      .tables = options.choice<bool>("shader", {{"exact", false}, {"tables", true}}),
      .words =
          options.choice<Words>("vbuffer", {{"float", Words::float32}, {"12bit", Words::split}})};
  options.check_all_known();
  refuse_what_is_not_treated(input.scene, volumes, shading, split);
  volumes.volumes.cone_forms = shading.tables;
  Visibility result;
  VolumePass pass(input, result);
  const Light& light = pass.scene().light;
  const bool words = shading.words == Words::split && light.shape != LightShape::point;
  const DrawRow kernel = make_kernel(light, shading);
  const auto draw = [&](const Light& part) {
    return words ? merged_split_words(pass.draw(part, volumes, kernel, 3))
                 : pass.draw(part, volumes, kernel);
  };
  MethodAccesses& accesses = result.accesses;
  if (split == 1) {
    result.values = draw(light);
  } else {
    // Each part has a silhouette of its own and lights what it lights, no less than nothing.
    result.values.resize(input.depth.words.size());
    const std::vector<Light> parts = light_parts(light, split);
    const float share = 1.0F / static_cast<float>(parts.size());
    for (const Light& part : parts) {
      const std::vector<float> values = draw(part);
      for (std::size_t i = 0; i < values.size(); ++i) {
        result.values[i] += share * std::clamp(values[i], 0.0F, 1.0F);
      }
    }
  }
  if (split > 1) {
    const std::uint64_t merges = static_cast<std::uint64_t>(split * split) * result.values.size();
    accesses.li_reads += merges;
    accesses.sums = 2 * merges;
  }
  accesses.bytes = 4 * (accesses.z_reads + accesses.li_reads + accesses.li_writes) +
                   MethodAccesses::kSumBytes * accesses.sums;
  if (shading.tables) {  // two angles of 16 bits and an area
    accesses.map_reads = 3 * pass.shares();
    accesses.bytes += (light.shape == LightShape::sphere ? 6 : 5) * pass.shares();
  }
  if (words) {  // how a coverage is split
    accesses.map_reads += pass.shares();
    accesses.bytes += 4 * pass.shares();
  }
  return result;
}

constexpr std::array<std::string_view, 4> kCompared{
    "ssv-optimized:shader=tables,vbuffer=12bit", "ssv-optimized:overlap=loops",
    "ssv-optimized:split=2", "ssv-optimized:split=4"};
constexpr std::array<std::string_view, 2> kArtifacts{"single-silhouette", "object-overlap"};

}  // namespace

const Method kSsvOptimized{
    .name = "ssv-optimized",
    .summary = "Soft shadow volumes: tight wedges, overlap heuristic, light splitting",
    .source = "Paper IV, 4 and 5",
    .options =
        "shader=exact|tables, vbuffer=float|12bit, split=1…4, overlap=sum|loops, "
        "wedges=tight|loose, halves=pixel|polygons, cull=tiles|none, z=auto|pass|fail",
    .compared = kCompared,
    .artifacts = kArtifacts,
    .render = render};

}  // namespace wedgesim::functional
