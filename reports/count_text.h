#pragma once

#include <span>
#include <string>

#include "model/count/count.h"
#include "model/count/wedge_check.h"
#include "reports/json.h"

namespace wedgesim::reports {

/// Every pixel of every configuration is within its tolerance, and no culling or acceptance was
/// wrong.
bool held(std::span<const model::CountResult> results);

/// All counters with unit and description, some configurations side by side, then pixels_text.
std::string count_text(const TraceInfo& trace, std::span<const model::CountResult> results);

/// One line that sums up the comparison with the expected LI over all configurations; for each of
/// those that failed, a line.
std::string pixels_text(std::span<const model::CountResult> results);

/// How many wedges are flagged, and why the worst is; nothing if none is.
std::string flags_text(std::span<const model::WedgeFlag> flagged);

/// The ten worst pixels of one configuration, as a table.
std::string worst_pixels_text(const model::PixelCheck& pixels);

}  // namespace wedgesim::reports
