#pragma once

#include <cstdint>

namespace wedgesim::model::memory {

/// A point in time, or a duration, in cycles of the block's clock.
using Cycle = std::uint64_t;

}  // namespace wedgesim::model::memory
