#pragma once

#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// How far rounding in double precision may move the coverage by a `coverage` wedge's edge, as seen
/// from a point: of the point in light space, a difference of large terms where the light is small
/// or the eye far; of the edge's ends as seen from there; of the part of the edge before the light,
/// a difference of the ends where one is far away. Where the light's centre may be on either side
/// of the edge, so may the point be of its shadow quad, and the coverage's sign is in doubt, too. A
/// running bound to first order, no more: units of full light, not cut off at 1.
/// \param x, y  the pixel's centre, pixels
/// \param z     window depth
double light_rounding(const traces::TraceView& trace, const traces::fb::Wedge& wedge, double x,
                      double y, double z);

}  // namespace wedgesim::reports::stress
