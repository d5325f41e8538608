#pragma once

#include <string>

#include "reports/study.h"

namespace wedgesim::reports {

/// The tables of a study: for each scene the accesses of both modes by tile size and by culling
/// test, what single-pass saves, the ratio to the floors, the best tile sizes, the pixel check;
/// at the end what single-pass saves overall (savings.h).
/// The same text for the same results.
std::string study_text(const StudyResults& results);

}  // namespace wedgesim::reports
