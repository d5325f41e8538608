#pragma once

#include "traces/trace_generated.h"

namespace wedgesim::reports::stress {

/// The sign of a trace's plane at a point, of the exact value of its coefficients: -1, 0 or 1.
/// \param x, y, z  window space: pixels and depth
int exact_sign(const traces::fb::Plane& plane, double x, double y, double z);

}  // namespace wedgesim::reports::stress
