#pragma once

#include <filesystem>

#include "reports/document.h"
#include "reports/json.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// What a study found: what was studied, the tables (for each configuration the median of the
/// study's metrics over frames and their 5th and 95th percentile; Paper II's where the study says
/// so), the check of the pixels, and the points that failed. The same text for the same results.
Document summary(const Results& results);

/// One line a point after a line of names: frame and its parameters, all keys of configuration,
/// state, all metrics. The same text for the same results.
std::string results_csv(const Results& results);

/// Schema wedgesim.study/1; nothing that differs between runs but under "timing".
Json results_json(const Results& results);

/// Writes summary.txt, summary.md, results.csv and results.json into a folder.
void write_results(const std::filesystem::path& folder, const Results& results);

/// Every point that is there is done, and its pixels held unless the study measures their errors.
bool held(const Results& results);

}  // namespace wedgesim::reports
