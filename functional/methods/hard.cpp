#include "functional/methods/hard.h"

#include <algorithm>
#include <array>

#include "functional/light/clearance.h"
#include "functional/light/light_cells.h"
#include "functional/methods/ssv_kernel.h"
#include "functional/methods/volume_pass.h"

namespace wedgesim::functional {
namespace {

constexpr int kStencilBytes = 1;
constexpr int kDepthBytes = 4;

Light point_at(const Light& light, const glm::dvec3& position) {
  Light point = light;
  point.shape = LightShape::point;
  point.centre = position;
  return point;
}

// 1 where the stencil counts no volume, else 0.
void add_lit(const std::vector<float>& words, float weight, std::vector<float>& values) {
  for (std::size_t i = 0; i < words.size(); ++i) values[i] += words[i] > 0.5F ? weight : 0.0F;
}

Visibility render_hard(const MethodInput& input, const MethodOptions& options) {
  const VolumeOptions volumes{.volumes = {.z = read_z(options)}};
  options.check_all_known();
  Visibility result;
  VolumePass pass(input, result);
  const Light& light = pass.scene().light;
  const std::vector<float> words = pass.draw(point_at(light, light.centre), volumes, hard_kernel());
  result.values.resize(words.size());
  add_lit(words, 1.0F, result.values);
  MethodAccesses& accesses = result.accesses;
  accesses.bytes =
      kDepthBytes * accesses.z_reads + kStencilBytes * (accesses.li_reads + accesses.li_writes);
  return result;
}

glm::dvec3 middle_of_casters(const Scene& scene) {
  Bounds bounds;
  for (const Object& object : scene.objects) {
    if (!object.casts) continue;
    for (const glm::dvec3& p : object.mesh.positions) bounds.grow(p);
  }
  return 0.5 * (bounds.low + bounds.high);
}

Visibility render_sampled(const MethodInput& input, const MethodOptions& options) {
  const int count = options.integer("samples", 64, 1, 1024);
  const VolumeOptions volumes{.volumes = {.z = read_z(options)}};
  options.check_all_known();
  Visibility result;
  VolumePass pass(input, result);
  const Scene& scene = pass.scene();
  for (const Object& object : scene.objects) {
    if (object.casts) check_light_is_clear(object.mesh, scene.light);
  }
  const std::vector<glm::dvec3> samples =
      cell_middles(scene.light, count, middle_of_casters(scene));
  result.values.resize(input.depth.words.size());
  for (const glm::dvec3& sample : samples) {
    add_lit(pass.draw(point_at(scene.light, sample), volumes, hard_kernel()), 1.0F, result.values);
  }
  const auto n = static_cast<float>(samples.size());
  for (float& value : result.values) value /= n;
  // Each sample's stencil is read and added to a sum of its own.
  MethodAccesses& accesses = result.accesses;
  const std::uint64_t merges = samples.size() * result.values.size();
  accesses.li_reads += merges;
  accesses.sums = 2 * merges;
  accesses.bytes = kDepthBytes * accesses.z_reads +
                   kStencilBytes * (accesses.li_reads + accesses.li_writes) +
                   MethodAccesses::kSumBytes * accesses.sums;
  return result;
}

constexpr std::array<std::string_view, 1> kHardCompared{"hard"};
constexpr std::array<std::string_view, 3> kSampledCompared{"sampled-16", "sampled-64",
                                                           "sampled-256"};
constexpr std::array<std::string_view, 1> kHardArtifacts{"no-penumbra"};
constexpr std::array<std::string_view, 1> kSampledArtifacts{"banding"};

}  // namespace

const Method kHard{.name = "hard",
                   .summary = "Shadow volumes from the light's centre",
                   .source = "Crow 1977, as Paper II, 2",
                   .options = "z=auto|pass|fail",
                   .compared = kHardCompared,
                   .artifacts = kHardArtifacts,
                   .render = render_hard};

const Method kSampled{.name = "sampled",
                      .summary = "The average of hard shadows from points of the light",
                      .source = "Paper III, 5.1: what its images are compared with",
                      .options = "samples=1…1024 (64), rounded down to a square; z=auto|pass|fail",
                      .compared = kSampledCompared,
                      .artifacts = kSampledArtifacts,
                      .render = render_sampled};

}  // namespace wedgesim::functional
