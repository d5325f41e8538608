#include "model/memory/config_check.h"

#include <fmt/format.h>

#include <bit>

#include "base/error.h"

namespace wedgesim::model::memory {
namespace {

template <typename Value>
[[noreturn]] void refuse(std::string_view place, std::string_view key, Value value,
                         const std::string& expected) {
  throw InputError(place, fmt::format("'{}' is {}", key, value), expected);
}

template <typename Value>
void check_in(std::string_view place, std::string_view key, Value value, Value low, Value high) {
  if (value < low || value > high) {
    refuse(place, key, value, fmt::format("an integer from {} to {}", low, high));
  }
}

}  // namespace

void check_range(std::string_view place, std::string_view key, std::uint64_t value,
                 std::uint64_t low, std::uint64_t high) {
  check_in(place, key, value, low, high);
}

void check_range(std::string_view place, std::string_view key, int value, int low, int high) {
  check_in(place, key, value, low, high);
}

void check_power_of_two(std::string_view place, std::string_view key, int value, int low,
                        int high) {
  if (value < low || value > high || !std::has_single_bit(static_cast<unsigned>(value))) {
    refuse(place, key, value, fmt::format("a power of two from {} to {}", low, high));
  }
}

void check_multiple(std::string_view place, std::string_view key, std::uint64_t value,
                    std::uint64_t step, std::uint64_t high) {
  if (value > high || value % step != 0) {
    refuse(place, key, value, fmt::format("a multiple of {} up to {}", step, high));
  }
}

}  // namespace wedgesim::model::memory
