#pragma once

#include <cstdint>
#include <vector>

#include "functional/methods/frame.h"
#include "model/count/operands.h"

namespace wedgesim::reports::stress {

/// Whether model::count gives the same words in modes, cullings and tile sizes of all kinds, by the
/// frame's own method.
/// \param sums  (height, width) of evaluate()
bool configurations_agree(const functional::Frame& frame, const model::Datapath& datapath,
                          const std::vector<std::int64_t>& sums);

}  // namespace wedgesim::reports::stress
