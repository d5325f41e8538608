#pragma once

#include <string>

#include "reports/study.h"

namespace wedgesim::reports {

/// One line a scene and configuration, after a line of column names: what names the run, all
/// counters, the comparison with the expected LI. The same text for the same results.
std::string study_csv(const StudyResults& results);

/// Schema wedgesim.study/1: "study", "configuration" and "scenes", each with "trace" and "configs"
/// as `count` gives them, or with "failure".
Json study_json(const StudyResults& results);

}  // namespace wedgesim::reports
