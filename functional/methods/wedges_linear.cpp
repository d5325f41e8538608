#include "functional/methods/wedges_linear.h"

#include <array>

#include "base/error.h"
#include "functional/methods/linear_volumes.h"
#include "functional/methods/ssv_kernel.h"
#include "functional/methods/volume_pass.h"

namespace wedgesim::functional {
namespace {

constexpr int kDepthBytes = 4;
constexpr int kIntensityBytes = 2;  // the papers' signed 16-bit buffer

bool read_cubic(const MethodOptions& options) {
  return options.choice<bool>("falloff", {{"linear", false}, {"cubic", true}});
}

Visibility draw(const MethodInput& input, const LinearChoices& choices, bool cull,
                const DrawRow& kernel) {
  Visibility result;
  VolumePass pass(input, result);
  const Light& light = pass.scene().light;
  if (!has_extent(light)) {
    throw InputError(input.scene.place, "a light without extent has no penumbra",
                     "a rectangle or a sphere");
  }
  const VolumePass::Build build = [&](const Scene& scene, const Window& window, const Light& from,
                                      const std::vector<ShadowCaster>& casters) {
    return build_linear_volumes(scene, window, from, casters, choices);
  };
  result.values = pass.draw(light, build, cull, false, kernel, 1);
  MethodAccesses& accesses = result.accesses;
  accesses.bytes =
      kDepthBytes * accesses.z_reads + kIntensityBytes * (accesses.li_reads + accesses.li_writes);
  return result;
}

Visibility render_2002(const MethodInput& input, const MethodOptions& options) {
  const bool cubic = read_cubic(options);
  const bool extra = options.choice<bool>("extra", {{"on", true}, {"off", false}});
  options.check_all_known();
  // z-pass whatever the eye is in: the paper has no other.
  return draw(input, {.z = ZChoice::automatic, .umbra_polygons = false, .round_corners = extra},
              false, entry_exit_kernel(cubic));
}

Visibility render_restructured(const MethodInput& input, const MethodOptions& options) {
  const bool cubic = read_cubic(options);
  const bool cull = options.choice<bool>("cull", {{"tiles", true}, {"none", false}});
  const ZChoice z = read_z(options);
  options.check_all_known();
  return draw(input, {.z = z}, cull, restructured_kernel(cubic));
}

constexpr std::array<std::string_view, 3> k2002Compared{"wedge-2002", "wedge-2002:falloff=cubic",
                                                        "wedge-2002:extra=off"};
constexpr std::array<std::string_view, 1> kRestructuredCompared{"wedge-restructured"};
constexpr std::array<std::string_view, 3> k2002Artifacts{"too-large-umbra", "leaking-umbra",
                                                         "eye-in-shadow"};
constexpr std::array<std::string_view, 2> kRestructuredArtifacts{"too-large-umbra",
                                                                 "leaking-umbra"};

}  // namespace

const Method kWedge2002{
    .name = "wedge-2002",
    .summary = "Penumbra wedges: intensity between where a ray enters and leaves",
    .source = "Paper I, 4 and 5",
    .options = "falloff=linear|cubic, extra=on|off (wedges at acute corners)",
    .compared = k2002Compared,
    .artifacts = k2002Artifacts,
    .render = render_2002};

const Method kWedgeRestructured{
    .name = "wedge-restructured",
    .summary = "Penumbra wedges: front faces as shadow volumes, then points inside",
    .source = "Paper II, 3 to 5",
    .options = "falloff=linear|cubic, cull=tiles|none, z=auto|pass|fail",
    .compared = kRestructuredCompared,
    .artifacts = kRestructuredArtifacts,
    .render = render_restructured};

}  // namespace wedgesim::functional
