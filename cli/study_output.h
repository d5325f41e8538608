#pragma once

#include <filesystem>
#include <string>

#include "reports/runner/results.h"

namespace wedgesim::cli {

/// Writes what the results of a study come to into their folder: results.csv and .json, summaries,
/// the page and, if the study measures claims, claims.md.
/// \param claims  a further file for the page of the claims; empty for none
/// \return the tables, as text
/// \throws InputError if a file cannot be written
std::string write_study(const std::filesystem::path& folder, const reports::Results& results,
                        const std::filesystem::path& claims = {});

}  // namespace wedgesim::cli
