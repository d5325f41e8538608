#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "reports/runner/results.h"

namespace wedgesim::reports {

/// Puts the results of a study's shards together: results.sqlite with all their rows, and their
/// traces and pictures, so that the study can go on there.
/// \param from  folders of shards, at least one
/// \param to    a folder without results, or with those of the same study
/// \throws InputError if they are not of one study, or made by different sources, if they disagree
///         on a point, or if `to` holds another study
Results merge_results(const std::vector<std::filesystem::path>& from,
                      const std::filesystem::path& to);

/// What two results differ in, a line each, key by key: studies, frames, points that only one has,
/// states and metrics. Timing is left out.
std::vector<std::string> differences(const Results& a, const Results& b);

}  // namespace wedgesim::reports
