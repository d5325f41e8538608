#pragma once

#include <cstdint>
#include <vector>

#include "functional/methods/frame.h"
#include "model/count/operands.h"
#include "model/count/primitive.h"
#include "reports/stress/errors.h"
#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// The frame of a case, with its own stored depths if it has some.
/// \throws InputError if the case is refused
functional::Frame frame_of(const Case& stress_case);

/// The method that the frame's expected LI was made by.
model::ZMethod method_of(const functional::Frame& frame);

/// The block's datapath that stands for an arithmetic; the renderer has none, and gets `exact`.
model::Datapath datapath_of(Arithmetic arithmetic, const Case& stress_case);

/// LI as the display reads it: what the word holds.
std::vector<double> li_of(const std::vector<std::int64_t>& sums, const model::Datapath& datapath);

}  // namespace wedgesim::reports::stress
