#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/count/operands.h"
#include "reports/stress/evaluate.h"
#include "reports/stress/trace_rounding.h"
#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// A primitive that a datapath may get wrong in this frame.
struct Flagged {
  std::uint32_t wedge = 0;  // or the number of wedges plus the index of a lone umbra polygon
  std::string reason;
  bool foreseen = false;  // from the trace and the datapath's own words, without comparing any
};

/// What can be known to be doubtful without a judge. A datapath itself foresees a primitive
/// - if at a pixel all that rounding may change (model/count/rounding_bound.h) adds up, with the
///   roundings of contributions (five standard deviations), to more than the tolerance and what is
///   sure of the sensitivity, and this primitive's part is not below the average;
/// - if the trace's doubles have lost what decides it (trace_rounding.h): a plane that LI jumps
///   across passes a pixel by less than its rounding, or the rounding of its edge or of its planes
///   may move a quarter of the tolerance, or its constants in double are rounded too far
///   (model/count/wedge_check.h);
/// - fixed: if LI leaves its word at a pixel of it;
/// - exact: also if a pixel of it has a reversed depth that is finer than double precision is.
///
/// Others show only by comparison, at a pixel of it and beyond the sensitivity: that
/// - exact differs from the trace's expected LI by a quarter of the datapath's tolerance;
/// - the datapath differs by its tolerance from exact, or from the expected LI.
///
/// \param evaluation  of the same frame and datapath
/// \param exact       of the same frame and the exact datapath
/// \param roundings   of the same trace
/// \return  by number, each once, the foreseen ones as such
std::vector<Flagged> flag(const traces::TraceView& trace, const model::Datapath& datapath,
                          const Evaluation& evaluation, const Evaluation& exact,
                          const std::vector<TraceRounding>& roundings);

}  // namespace wedgesim::reports::stress
