#include "functional/methods/raytraced.h"

#include <algorithm>
#include <array>

#include "functional/methods/stopwatch.h"
#include "functional/reference/reference.h"

namespace wedgesim::functional {
namespace {

Visibility render(const MethodInput& input, const MethodOptions& options) {
  const int samples = options.integer("samples", 1024, 1, 1 << 20);
  options.check_all_known();
  Visibility result;
  Stopwatch stopwatch(result);
  result.channels = input.scene.light.texture ? 3 : 1;
  result.values = reference_visibility(input.scene, input.window, input.depth, samples);
  stopwatch.end("pixels");
  const std::size_t pixels = input.depth.words.size();
  result.accesses.z_reads = pixels;
  result.accesses.li_writes = result.values.size();
  result.accesses.bytes = 4 * (result.accesses.z_reads + result.accesses.li_writes);
  return result;
}

constexpr std::array<std::string_view, 3> kCompared{"raytraced-16", "raytraced-64",
                                                    "raytraced-256"};

}  // namespace

const Method kRaytraced{.name = "raytraced",
                        .summary = "Rays from each pixel to stratified samples of the light",
                        .source = "Embree; the papers' reference images",
                        .options =
                            "samples=1…1048576 (1024), rounded down to a square number; a texture: "
                            "one a texel at least",
                        .compared = kCompared,
                        .artifacts = {},
                        .takes_textures = true,
                        .render = render};

}  // namespace wedgesim::functional
