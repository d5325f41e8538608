#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// The soft shadow occlusion camera: a camera at the light's centre whose rays bend round
/// silhouettes, so that a fragment of a penumbra is seen; how far its ray bends is its shadow.
/// Source: seed 003 of the papers, 3.2 to 5. The light is a sphere: a rectangle becomes the one of
/// radius (|half_u| + |half_v|) / 2, a point casts the map's hard shadow.
extern const Method kOcclusionCamera;

}  // namespace wedgesim::functional
