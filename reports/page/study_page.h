#pragma once

#include <filesystem>

#include "reports/page/page.h"

namespace wedgesim::reports::page {

/// The page's file in a study's folder.
std::filesystem::path page_path(const std::filesystem::path& folder);

/// Writes the page of the results in a folder: with heat maps of its traces, the papers' claims if
/// the study measures them, links to its other files. Beside it the maps and, of a study in cycles,
/// timeline.json.
/// \param path  of the page; links hold only in the folder itself
/// \throws InputError if a trace is not sound or a file cannot be written
void write_study_page(const std::filesystem::path& folder, const Results& results,
                      const std::filesystem::path& path);

}  // namespace wedgesim::reports::page
