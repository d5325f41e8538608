#pragma once

#include <iosfwd>
#include <string>

#include "traces/trace.h"

namespace wedgesim::traces {

/// Writes all of a trace as JSON with the field names of trace.fbs; enumerations by name, absent
/// sections null. Numbers read back as the same bits (a NaN, which no verified trace holds, is
/// null). flatc with trace.fbs accepts it. Streams: needs no memory of the trace's size.
void dump_json(std::ostream& out, const TraceView& trace);

/// Writes the wedges as an OBJ mesh in world space: vertex n + 1 is vertices[n], a group `wedge_i`
/// for each wedge, its faces counter-clockwise as seen from outside. Faces with a vertex that has
/// no place in the world (w not positive) are left out, and a comment says so.
void dump_obj(std::ostream& out, const TraceView& trace);

/// One line a section with what it holds, for a user who asks what is in a file.
std::string summary(const TraceView& trace);

}  // namespace wedgesim::traces
