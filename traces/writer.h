#pragma once

#include <cstdint>
#include <filesystem>
#include <string_view>

#include "traces/trace.h"

namespace wedgesim::traces {

/// Known before a frame is rendered: whether its depth, expected LI and sensitivity fit into a
/// trace's 2 GB.
/// \throws  InputError at `place` if they do not
void require_room(std::string_view place, int width, int height);

/// Writes a trace file, whole or not at all. The trace is verified first (verify.h); the same trace
/// gives the same bytes. Takes the trace's size again in memory.
/// \return  the checksum of the payload, as the reader puts it into Header::checksum
/// \throws  InputError if the trace is not sound, if its payload would pass 2 GB, or if the file
///          cannot be written
std::uint64_t write_trace(const std::filesystem::path& path, const TraceView& trace);
std::uint64_t write_trace(const std::filesystem::path& path, const Trace& trace);

}  // namespace wedgesim::traces
