#pragma once

#include <glm/vec4.hpp>

#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// A point of the window in the world, as the trace's matrix in double precision has it:
/// homogeneous, w > 0 is one over the distance of view.
/// \param x, y  pixels
/// \param z     window depth
glm::dvec4 world_point(const traces::TraceView& trace, double x, double y, double z);

/// A plane of the window, coefficients a to d, in the world; its normal is no unit vector. The
/// plane's value in the window is that in the world over the distance of view.
glm::dvec4 world_plane(const traces::TraceView& trace, const glm::dvec4& window_plane);

}  // namespace wedgesim::reports::stress
