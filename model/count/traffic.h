#pragma once

#include <bit>
#include <cstdint>

#include "model/count/config.h"
#include "model/count/counters.h"
#include "traces/trace_generated.h"

namespace wedgesim::model {

/// Bytes of one word of LI and stencil, as a block stores them: whole bytes, a power of two.
struct WordBytes {
  std::uint64_t li = 2;       // S5_11, or 16-bit integers
  std::uint64_t stencil = 1;  // 8 bits, two's complement
};
constexpr std::uint64_t bytes_of_bits(int bits) {
  return std::bit_ceil(static_cast<std::uint64_t>(bits + 7) / 8);
}
/// Depth, and the tiles' zmin and zmax; unorm24 fills a 32-bit word.
constexpr std::uint64_t depth_bytes(traces::fb::DepthFormat format) {
  return format == traces::fb::DepthFormat_unorm16 ? 2 : 4;
}

/// Sets the counters that follow from others: reads to modify, merges, clears, all_bytes.
/// \param pixels        of the frame
/// \param merged        pixels whose stencil is not 0 when it is merged
void finish_traffic(Counters& counters, Mode mode, traces::fb::DepthFormat format,
                    std::uint64_t pixels, std::uint64_t merged, const WordBytes& bytes = {});

}  // namespace wedgesim::model
