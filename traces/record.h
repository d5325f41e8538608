#pragma once

#include <cstdint>

#include "traces/trace.h"

namespace wedgesim::traces {

/// A vertex in a record: x and y (4 bytes each) and z (8 bytes).
inline constexpr std::uint64_t kVertexRecordBytes = 16;

/// Bytes of the input record of one wedge: what the block fetches to rasterize it. That is the
/// wedge, its planes, its faces with their indices, its umbra polygon with its indices, and
/// kVertexRecordBytes for each distinct vertex that these name (docs/trace.md, "The input record").
/// \param trace  a verified trace (verify.h)
/// \param wedge  index into trace.wedges
std::uint64_t wedge_record_bytes(const TraceView& trace, std::uint32_t wedge);

}  // namespace wedgesim::traces
