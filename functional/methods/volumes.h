#pragma once

#include <string>
#include <vector>

#include "functional/geometry/extent.h"
#include "functional/geometry/near_pyramid.h"
#include "functional/geometry/silhouette.h"
#include "functional/raster/screen_volume.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// How volumes count: z-pass but z-fail for casters that need it, or one of them for all.
enum class ZChoice { automatic, pass, fail };

struct VolumeChoices {
  ZChoice z = ZChoice::automatic;
  bool tight_wedges = true;  // else those of Paper III where they reach (loose_wedge.h)
  bool in_halves = false;    // wedges inside and outside of the shadow apart (Paper IV, 4.4)
  bool by_groups = false;    // sides sorted by the loops that shadow together (loop_groups.h)
  bool cone_forms = false;   // a sphere's wedges with cone_forms, not coverage_forms
};

/// A caster as a light's centre sees it.
struct ShadowCaster {
  const Mesh* mesh = nullptr;
  Silhouette silhouette;
  EndPlane end_plane;  // where its volumes end
};

/// Silhouettes of all casters that have one, and where their volumes end.
/// \throws InputError if the light touches a caster or its penumbra spans a half-space
std::vector<ShadowCaster> find_casters(const Scene& scene, const Light& light);

/// Whether z-pass is wrong for a caster even if the near pyramid meets none of its umbra polygons
/// and wedges: the eye is in its umbra, or it looks in through what z-pass leaves open, a
/// light-facing triangle in the near pyramid or the end of the volume.
bool ends_need_z_fail(const ShadowCaster& caster, const glm::dvec3& light_centre,
                      const NearPyramid& pyramid);

/// \throws InputError always: z-pass is wrong here
[[noreturn]] void refuse_z_pass(const std::string& place);

/// Shadow volumes on the screen: the umbra polygons of all silhouette edges, each with the coverage
/// wedge (wedge.h) of a light with extent; caps and bottoms where z-fail needs them.
/// \throws InputError if z-pass is asked for where it is wrong
std::vector<ScreenSide> build_volumes(const Scene& scene, const Window& window, const Light& light,
                                      const std::vector<ShadowCaster>& casters,
                                      const VolumeChoices& choices);

}  // namespace wedgesim::functional
