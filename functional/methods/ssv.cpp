#include "functional/methods/ssv.h"

#include <array>

#include "functional/methods/ssv_kernel.h"
#include "functional/methods/volume_pass.h"

namespace wedgesim::functional {
namespace {

Visibility render(const MethodInput& input, const MethodOptions& options) {
  const VolumeOptions volumes{
      .z = read_z(options),
      .cull = options.choice<bool>("cull", {{"tiles", true}, {"none", false}})};
  options.check_all_known();
  Visibility result;
  VolumePass pass(input, result);
  const Light& light = pass.scene().light;
  result.values = pass.draw(light, volumes, coverage_kernel(light.shape));
  const MethodAccesses& accesses = result.accesses;
  result.accesses.bytes = 4 * (accesses.z_reads + accesses.li_reads + accesses.li_writes);
  return result;
}

constexpr std::array<std::string_view, 1> kCompared{"ssv"};
constexpr std::array<std::string_view, 2> kArtifacts{"single-silhouette", "object-overlap"};

}  // namespace

const Method kSsv{.name = "ssv",
                  .summary = "Soft shadow volumes: wedges with exact clipping on the light",
                  .source = "Paper III, 3",
                  .options = "z=auto|pass|fail, cull=tiles|none",
                  .compared = kCompared,
                  .artifacts = kArtifacts,
                  .render = render};

}  // namespace wedgesim::functional
