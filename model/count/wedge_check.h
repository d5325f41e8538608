#pragma once

#include <cstdint>
#include <string_view>
#include <vector>

#include "model/count/operands.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// Why a datapath may be wrong at a wedge.
enum class FlagReason {
  plane,  // rounding may move one of its planes, or its umbra polygon's, visibly
  light,  // rounding may move its silhouette edge as seen from a point
  edge,   // its silhouette edge has no length, hence no direction
};

struct WedgeFlag {
  std::uint32_t wedge = 0;
  FlagReason reason{};
  double value = 0.0;  // how many times farther than allowed, see flag_wedges; above 1
};

/// In JSON: plane, light, edge.
std::string_view name(FlagReason reason);
/// In words.
std::string_view describe(FlagReason reason);

/// The wedges that a datapath may get wrong, judged by their constants alone, before any pixel is.
///
/// A form a x + b y + c z + d that is off by E has its zero off by E / |c per step| steps of z, or,
/// read along the screen, by E / max(|a|, |b|) pixels. A point that lies farther from the zero is
/// decided rightly, and its light differs by no more than what so much of a step changes, which a
/// pixel's sensitivity allows. So a form is good if either is small: an eighth of a step, so that
/// several wedges may err at one pixel, or 1/2048 pixel, which few pixel centres are near to.
/// E is a bound, over the whole frame and all depths of the forms' rounding alone:
/// - `fixed`: each coefficient is off by half a unit, (X + Y + Z + 1) / 2 units in all, with X
///   and Y the frame's edges in half pixels and Z its depth in steps;
/// - in floating point: of four products and three sums, each off by at most u of what it adds to,
///   4 u (|a| X + |b| Y + |c| + |d|), u = 2^-24 or 2^-53.
/// \return  in the order of the wedges; the worst form of each
std::vector<WedgeFlag> flag_wedges(const traces::TraceView& trace, const Datapath& datapath);

}  // namespace wedgesim::model
