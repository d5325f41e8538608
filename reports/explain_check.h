#pragma once

#include "model/count/explain.h"
#include "traces/trace.h"

namespace wedgesim::reports {

/// An explained pixel sums up to the trace's expected LI, as far as `count` compares it: within
/// 1e-6 plus its sensitivity; sky pixels under the trace's own z method alone.
bool held(const traces::TraceView& trace, const model::Explanation& explanation);

}  // namespace wedgesim::reports
