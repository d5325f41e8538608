#include "base/error.h"

#include <fmt/format.h>

namespace wedgesim {

InputError::InputError(std::string_view place, std::string_view problem, std::string_view expected)
    : std::runtime_error(expected.empty()
                             ? fmt::format("{}: {}", place, problem)
                             : fmt::format("{}: {}; expected {}", place, problem, expected)) {}

}  // namespace wedgesim
