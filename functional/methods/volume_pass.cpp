#include "functional/methods/volume_pass.h"

#include "base/error.h"
#include "functional/scene/origin.h"

namespace wedgesim::functional {

ZChoice read_z(const MethodOptions& options) {
  return options.choice<ZChoice>(
      "z", {{"auto", ZChoice::automatic}, {"pass", ZChoice::pass}, {"fail", ZChoice::fail}});
}

VolumePass::VolumePass(const MethodInput& input, Visibility& result)
    : input_(input),
      result_(result),
      stopwatch_(result),
      window_(input.window),
      tiles_(input.depth) {
  stopwatch_.end("tiles");
  const glm::dvec3 origin = best_origin(input.scene);
  if (origin == glm::dvec3(0.0)) return;
  moved_ = taken_from(input.scene, origin);
  window_ = make_window(moved_->camera, moved_->width, moved_->height);
}

std::vector<float> VolumePass::draw(const Light& light, const VolumeOptions& options,
                                    const DrawRow& draw_row, int channels) {
  const Build build = [&](const Scene& scene, const Window& window, const Light& from,
                          const std::vector<ShadowCaster>& casters) {
    return build_volumes(scene, window, from, casters, options.volumes);
  };
  return draw(light, build, options.cull, options.volumes.by_groups, draw_row, channels);
}

std::vector<float> VolumePass::draw(const Light& light, const Build& build, bool cull,
                                    bool merge_groups, const DrawRow& draw_row, int channels) {
  if (light.shape != LightShape::point && !has_extent(light)) {
    throw InputError(input_.scene.place, "the light has no extent", "a point light");
  }
  const std::vector<ShadowCaster> casters = find_casters(scene(), light);
  stopwatch_.end("silhouettes");
  const std::vector<ScreenSide> sides = build(scene(), window_, light, casters);
  stopwatch_.end("volumes");
  DrawnVolumes drawn = draw_volumes({tiles_, sides, cull, merge_groups}, draw_row, channels);
  result_.accesses.z_reads += drawn.accesses.z_reads;
  result_.accesses.li_reads += drawn.accesses.light_reads;
  result_.accesses.li_writes += drawn.accesses.light_writes;
  shares_ += drawn.accesses.shares;
  stopwatch_.end("pixels");
  return std::move(drawn.values);
}

}  // namespace wedgesim::functional
