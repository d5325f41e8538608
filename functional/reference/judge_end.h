#pragma once

#include "functional/methods/frame.h"
#include "functional/reference/real.h"

namespace wedgesim::functional {

/// A plane by a point of it, relative to the light's centre.
struct RealPlane {
  RealVector inward, through;
};

/// The plane in which the volumes of an object's shadow end, from the definition in extent.h and
/// the scene as it was given. Data are which side was chosen, the fixed length, and of another
/// renderer's depth image the bounds of what it shows.
/// \param object  of the scene; casts
/// \return        world axes, inward before the end
RealPlane judged_end(const Scene& scene, const Frame& frame, std::size_t object);

}  // namespace wedgesim::functional
