#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functional/methods/method.h"
#include "functional/methods/occlusion_lookup.h"

namespace wedgesim::functional {

/// What reaches each pixel of a frame. Tiles of the light's maps that no strip is near decide most,
/// many pixels at once; a lookup decides the others.
/// \param facing  of each triangle of the scene, as the depth buffer numbers them
/// \param values  of each pixel; those that the light's camera does not see keep theirs
OcclusionLookup::Count light_pixels(const MethodInput& input, const Window& light_window,
                                    const OcclusionLookup& lookup, std::span<const Facing> facing,
                                    std::vector<float>& values);

}  // namespace wedgesim::functional
