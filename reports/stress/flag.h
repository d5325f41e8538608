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
  bool by_constants = false;  // by its constants alone: `count` flags it, too
};

/// What can be known to be doubtful without a judge: a primitive is flagged
/// - by its constants (model/count/wedge_check.h);
/// - exact: if a plane that LI jumps across passes a pixel by less than its rounding;
/// - if exact, at a pixel of it, differs from the trace's expected LI by a quarter of the
///   datapath's tolerance and the sensitivity;
/// - not exact: if at a pixel it gives, or all give together, what differs visibly from exact;
/// - fixed: if LI leaves its word at a pixel of it, or if so many contributions are rounded there
///   that they may add up to more than the tolerance (five standard deviations);
/// - if a pixel of it has a reversed depth that is finer than double precision holds it.
///
/// \param evaluation  of the same frame and datapath
/// \param exact       of the same frame and the exact datapath
/// \return  by number, each once
std::vector<Flagged> flag(const traces::TraceView& trace, const model::Datapath& datapath,
                          const Evaluation& evaluation, const Evaluation& exact);

}  // namespace wedgesim::reports::stress
