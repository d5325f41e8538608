#pragma once

#include <bit>
#include <cmath>
#include <cstdint>

#include "traces/trace_generated.h"

namespace wedgesim::traces {

/// The stored word of a window depth, rounded to nearest.
/// \param z  [0, 1], 0 near; values outside are clamped
inline std::uint32_t encode_depth(fb::DepthFormat format, double z) {
  z = z < 0.0 ? 0.0 : (z > 1.0 ? 1.0 : z);
  switch (format) {
    case fb::DepthFormat_unorm24:
      return static_cast<std::uint32_t>(std::nearbyint(z * 16777215.0));
    case fb::DepthFormat_unorm16:
      return static_cast<std::uint32_t>(std::nearbyint(z * 65535.0));
    case fb::DepthFormat_float32:
      return std::bit_cast<std::uint32_t>(static_cast<float>(z));
    case fb::DepthFormat_float32_reversed:
      return std::bit_cast<std::uint32_t>(static_cast<float>(1.0 - z));
  }
  return 0;
}

/// The window depth of a stored word: [0, 1], 0 near.
inline double decode_depth(fb::DepthFormat format, std::uint32_t word) {
  switch (format) {
    case fb::DepthFormat_unorm24:
      return word / 16777215.0;
    case fb::DepthFormat_unorm16:
      return word / 65535.0;
    case fb::DepthFormat_float32:
      return static_cast<double>(std::bit_cast<float>(word));
    case fb::DepthFormat_float32_reversed:
      return 1.0 - static_cast<double>(std::bit_cast<float>(word));
  }
  return 0.0;
}

/// The word of the sky: window depth 1.
inline std::uint32_t sky_word(fb::DepthFormat format) { return encode_depth(format, 1.0); }

/// The word of a depth one step nearer (-1) or farther (+1), kept within [0, 1].
inline std::uint32_t step_depth(fb::DepthFormat format, std::uint32_t word, int farther) {
  const bool reversed = format == fb::DepthFormat_float32_reversed;
  const bool unorm = format == fb::DepthFormat_unorm24 || format == fb::DepthFormat_unorm16;
  const std::int64_t top = unorm ? sky_word(format) : std::bit_cast<std::uint32_t>(1.0F);
  const std::int64_t moved = std::int64_t{word} + (reversed ? -farther : farther);
  return static_cast<std::uint32_t>(moved < 0 ? 0 : (moved > top ? top : moved));
}

}  // namespace wedgesim::traces
