#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "model/count/operands.h"
#include "reports/stress/evaluate.h"
#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// A primitive that a datapath may get wrong in this frame.
struct Flagged {
  std::uint32_t wedge = 0;  // or the number of wedges plus the index of a lone umbra polygon
  std::string reason;
};

/// What can be known to be doubtful without a judge:
/// - its constants lose what a pixel shows (model/count/wedge_check.h);
/// - the exact datapath: a plane that LI jumps across passes a pixel by less than its rounding, or
/// a
///   pixel differs from the trace's expected LI;
/// - a pixel's reversed depth is finer than double precision holds it;
/// - the others: at a pixel it gives, or all together give, what differs visibly from what the
///   exact datapath gives;
/// - a pixel's LI leaves its word, or takes so many contributions that their roundings may add up
/// to
///   more than the tolerance (five standard deviations): all primitives there.
/// \param evaluation  of the same frame and datapath
/// \param exact       of the same frame and the exact datapath
/// \return  by number, each once
std::vector<Flagged> flag(const traces::TraceView& trace, const model::Datapath& datapath,
                          const Evaluation& evaluation, const Evaluation& exact);

}  // namespace wedgesim::reports::stress
