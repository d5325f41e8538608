#pragma once

#include <filesystem>

#include "reports/page/columns.h"

namespace wedgesim::reports::page {

/// Runs the best configuration of a study in time once more, on the first of its frames whose trace
/// is in the folder, and writes what its units do in the first cycles to FOLDER/timeline.json
/// (timeline.h). Does nothing for a study that measures no cycles.
/// \throws InputError if the trace is not sound or the file cannot be written
void write_timeline(const Columns& columns, const std::filesystem::path& folder);

}  // namespace wedgesim::reports::page
