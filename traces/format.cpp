#include "traces/format.h"

#include <xxhash.h>

namespace wedgesim::traces {

std::uint64_t checksum_of(std::span<const std::byte> payload) {
  return XXH3_64bits(payload.data(), payload.size());
}

}  // namespace wedgesim::traces
