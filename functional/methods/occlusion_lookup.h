#pragma once

#include <cstdint>
#include <glm/vec2.hpp>
#include <span>
#include <vector>

#include "functional/methods/distortion_map.h"
#include "functional/methods/facing.h"
#include "functional/methods/light_depths.h"
#include "functional/methods/penumbra_strips.h"

namespace wedgesim::functional {

/// What a point of the scene is to the light's camera.
struct Fragment {
  glm::vec2 place{0.0F};       // texels
  float inverse_depth = 0.0F;  // 1/z, world units along the camera's axis
  Facing facing = Facing::light;
};

/// The visible fraction of the light at fragments, by the maps of an occlusion camera.
/// Source: soft shadow occlusion camera, 3.2.2, 3.2.3 and 4.
class OcclusionLookup {
 public:
  struct Options {
    int lookups = 3;          // most distortions of a fragment, 1 to 4
    bool interpolate = true;  // between the four texels about a fragment
    double bias = 2.0;        // see hidden_after
  };
  struct Count {
    std::uint64_t depth_reads = 0, map_reads = 0;
  };

  /// Of its depth: a nearer surface hides a fragment.
  static constexpr float kOwnDepth = 1.0F - 1e-4F;

  OcclusionLookup(const ShadowMaps& shadows, std::span<const PenumbraStrip> strips,
                  const DistortionMap& map, double focal, const Options& options);

  const Options& options() const { return options_; }
  /// Texels along an edge of the light's maps.
  int size() const { return casters_.size(); }
  /// What the casters' depths are in each tile; 0 to infinity, which decides nothing, where a strip
  /// may be near.
  std::span<const TileDepths> tiles() const { return tiles_; }

  /// \param fragment  within the light's image, half a texel inside, and not facing away
  /// \return [0, 1]
  float visible(const Fragment& fragment, Count& count) const;

 private:
  struct Bend;
  /// What a texel says of a fragment; without a strip the caster alone.
  struct Texel {
    bool covered = false;
    StripName name;
    bool operator==(const Texel&) const = default;
  };
  Texel texel_at(const Fragment& fragment, int x, int y, Count& count) const;
  float visible_by_texel(const Fragment& fragment, const Texel& texel, Count& count) const;
  bool hidden(int x, int y, float inverse_depth, Count& count) const;
  bool hidden_after(const glm::vec2& place, const Fragment& fragment, Count& count) const;
  StripName name_at(const glm::vec2& place, bool inside, Count& count) const;
  Bend bend(StripName name, const Fragment& fragment) const;

  const LightDepths& casters_;
  std::vector<TileDepths> tiles_;
  std::span<const PenumbraStrip> strips_;
  const DistortionMap& map_;
  float inverse_focal_;
  Options options_;
};

}  // namespace wedgesim::functional
