#pragma once

#include <filesystem>
#include <vector>

#include "reports/page/page.h"

namespace wedgesim::reports::page {

/// The page's file in a study's folder.
std::filesystem::path page_path(const std::filesystem::path& folder);

/// Writes the page of the results in a folder: heat maps of its traces, links to its other files.
/// \param path  of the page; links hold only in the folder itself
/// \param sections  tables of others
/// \throws InputError if a trace is not sound or a file cannot be written
void write_study_page(const std::filesystem::path& folder, const Results& results,
                      const std::filesystem::path& path, const std::vector<Section>& sections = {});

}  // namespace wedgesim::reports::page
