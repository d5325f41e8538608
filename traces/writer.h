#pragma once

#include <cstdint>
#include <filesystem>

#include "traces/trace.h"

namespace wedgesim::traces {

/// Writes a trace file, whole or not at all. The trace is verified first (verify.h); the same trace
/// gives the same bytes. Takes the trace's size again in memory.
/// \return  the checksum of the payload, as the reader puts it into Header::checksum
/// \throws  InputError if the trace is not sound, if its payload would pass 2 GB, or if the file
///          cannot be written
std::uint64_t write_trace(const std::filesystem::path& path, const TraceView& trace);
std::uint64_t write_trace(const std::filesystem::path& path, const Trace& trace);

}  // namespace wedgesim::traces
