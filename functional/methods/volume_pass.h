#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "functional/methods/method.h"
#include "functional/methods/stopwatch.h"
#include "functional/methods/volumes.h"
#include "functional/raster/volume_raster.h"

namespace wedgesim::functional {

struct VolumeOptions {
  VolumeChoices volumes;
  bool cull = true;  // wedges by tiles
};
/// The option z=auto|pass|fail.
ZChoice read_z(const MethodOptions& options);

/// What all methods that draw shadow volumes do for a frame, for one light or several in turn:
/// silhouettes, volumes, pixels. Adds the stages' times and the accesses to a result.
class VolumePass {
 public:
  VolumePass(const MethodInput& input, Visibility& result);

  /// The scene as the volumes are built from it: about an origin that keeps digits (origin.h).
  const Scene& scene() const { return moved_ ? *moved_ : input_.scene; }

  /// Draws the volumes of a light of this scene, or of a part of one.
  /// \return (channel, height, width), not clamped
  /// \throws InputError if the light touches a caster, or has a shape but no extent
  std::vector<float> draw(const Light& light, const VolumeOptions& options, const DrawRow& draw_row,
                          int channels = 1);
  /// The same with the volumes that build(scene, window, light, casters) gives.
  using Build = std::function<std::vector<ScreenSide>(const Scene& scene, const Window& window,
                                                      const Light& light,
                                                      const std::vector<ShadowCaster>& casters)>;
  std::vector<float> draw(const Light& light, const Build& build, bool cull, bool merge_groups,
                          const DrawRow& draw_row, int channels);

  /// Ends a stage of the method's own.
  void end(std::string_view stage) { stopwatch_.end(stage); }
  /// How often a wedge added its share to a pixel, in all that was drawn.
  std::uint64_t shares() const { return shares_; }

 private:
  const MethodInput& input_;
  Visibility& result_;
  Stopwatch stopwatch_;
  std::optional<Scene> moved_;
  Window window_;
  DepthTiles tiles_;
  std::uint64_t shares_ = 0;
};

}  // namespace wedgesim::functional
