#pragma once

#include <cstdint>

namespace wedgesim::model::units {

/// What a unit does in a cycle.
enum class UnitState : std::uint8_t { busy, starved, stalled };

}  // namespace wedgesim::model::units
