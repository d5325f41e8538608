#pragma once

#include <filesystem>

#include "reports/page/columns.h"
#include "reports/page/page.h"

namespace wedgesim::reports::page {

/// Counts some frames of a study again to draw where their accesses fall: the largest frame
/// of each of up to three scenes whose trace is in the study's folder, in every mode and tile size
/// of the study, other settings as its charts hold them. Full-size pictures go to FOLDER/maps, as
/// PNG in false colours and as EXR; FOLDER/LABEL_shaded.png, if it is there, becomes the frame's
/// picture. \throws InputError if a trace is not sound or a file cannot be written
void add_heat_maps(const Columns& columns, const std::filesystem::path& folder, Page& page);

}  // namespace wedgesim::reports::page
