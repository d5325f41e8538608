#pragma once

#include <cstdint>
#include <string_view>

namespace wedgesim::model::memory {

/// Each throws InputError unless the value of a configuration's key is in its range (closed).
void check_range(std::string_view place, std::string_view key, std::uint64_t value,
                 std::uint64_t low, std::uint64_t high);
void check_range(std::string_view place, std::string_view key, int value, int low, int high);
void check_power_of_two(std::string_view place, std::string_view key, int value, int low, int high);
/// A multiple of `step` from 0 to `high`.
void check_multiple(std::string_view place, std::string_view key, std::uint64_t value,
                    std::uint64_t step, std::uint64_t high);

}  // namespace wedgesim::model::memory
