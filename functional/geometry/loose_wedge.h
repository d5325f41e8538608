#pragma once

#include <optional>

#include "functional/geometry/wedge.h"

namespace wedgesim::functional {

/// The wedge of Paper III, 3.1: the end farther from the light moved towards its centre until both
/// are as far, then four planes through the new edge and its ends that touch the sphere around the
/// light. It holds the penumbra of the edge, less tightly than coverage_wedge.
/// \return none where its sides do not all reach the end plane, or the edge points at the light
std::optional<WorldWedge> loose_wedge(const Light& light, const glm::dvec3& begin,
                                      const glm::dvec3& end, const EndPlane& end_plane);

}  // namespace wedgesim::functional
