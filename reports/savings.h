#pragma once

#include <string>

#include "reports/study.h"

namespace wedgesim::reports {

/// What single-pass saves against three-pass over all scenes and tile sizes of a study, at equal
/// and at unequal acceptance, beside what Paper II claims; empty if the study lacks a mode.
std::string savings_text(const StudyResults& results);

}  // namespace wedgesim::reports
