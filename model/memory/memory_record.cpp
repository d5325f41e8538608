#include "model/memory/memory_record.h"

#include <array>

namespace wedgesim::model::memory {

std::string_view name_of(Cause cause) {
  constexpr std::array<std::string_view, 8> kNames{"fetch", "fill",  "write_back", "write_through",
                                                   "flush", "clear", "build",      "merge"};
  return kNames[static_cast<std::size_t>(cause)];
}

}  // namespace wedgesim::model::memory
