#pragma once

#include "reports/document.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// What single-pass saves against three-pass over all frames and tile sizes of a study, at equal
/// and at unequal acceptance, beside what Paper II claims; empty if the study lacks a mode.
Document savings_text(const Results& results);

}  // namespace wedgesim::reports
