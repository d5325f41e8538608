#pragma once

#include <cstdint>
#include <string_view>

#include "base/limits.h"
#include "traces/trace.h"

namespace wedgesim::traces {

/// What a sound trace may hold (docs/trace.md, "What is refused").
inline constexpr std::uint32_t kMaxSide = kMaxFrameEdge;
inline constexpr std::int32_t kMaxSnapped = 1 << 24;  // 1/256 pixels, either sign
inline constexpr std::uint32_t kMaxPolygonVertices = 64;
inline constexpr std::uint32_t kMaxWedgePlanes = 8;
inline constexpr std::uint32_t kMaxWedgeFaces = 64;
inline constexpr std::uint32_t kMaxLights = 1024;
inline constexpr std::uint32_t kMaxCasters = 65536;

/// Checks that a trace means something: sizes, references, ranges, finite numbers. A trace that
/// passes can be walked without a further check.
/// \param place  what errors name: the file
/// \throws       InputError naming section, index and field of the first thing that is wrong
void verify(const TraceView& trace, std::string_view place);

}  // namespace wedgesim::traces
