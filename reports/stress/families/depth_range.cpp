#include <utility>

#include "reports/stress/families/groups.h"
#include "reports/stress/families/parts.h"

namespace wedgesim::reports::stress {
namespace {

using traces::fb::DepthFormat;

// The near plane comes nearer to the eye; all else stays.
template <DepthFormat format>
Case near_far(std::uint64_t seed, double ratio) {
  Stage stage = make_stage(seed, kLightRadius);
  add_plate(stage);
  stage.camera().near_plane = stage.camera().far_plane / ratio;
  stage.result.options.depth_format = format;
  return std::move(stage.result);
}

Family family(std::string_view name, Family::Required required,
              Case (*make)(std::uint64_t, double)) {
  return {name, "far plane over near plane", "", decades(1, 12), required, make};
}

}  // namespace

std::vector<Family> depth_range_families() {
  return {
      family("near-far-unorm16", {}, near_far<DepthFormat::DepthFormat_unorm16>),
      family("near-far-unorm24", {1e4, 1e5}, near_far<DepthFormat::DepthFormat_unorm24>),
      family("near-far-float32", {1e4, 1e4}, near_far<DepthFormat::DepthFormat_float32>),
      family("near-far-reversed", {1e6, 1e8}, near_far<DepthFormat::DepthFormat_float32_reversed>),
  };
}

}  // namespace wedgesim::reports::stress
