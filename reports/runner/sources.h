#pragma once

#include <string_view>

namespace wedgesim::reports {

/// The hash of the sources that decide results: 64 hexadecimal digits, the same wherever the same
/// sources are built. Results of different sources are not put together.
std::string_view sources_hash();

}  // namespace wedgesim::reports
