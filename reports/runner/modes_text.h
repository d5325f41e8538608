#pragma once

#include "reports/document.h"
#include "reports/runner/results.h"

namespace wedgesim::reports {

/// Paper II's tables: for each frame the accesses of both modes by tile size and by culling test,
/// what single-pass saves, the ratio to the floors, the best tile sizes, the pixel check; at the
/// end what single-pass saves over all frames and tile sizes, at equal and at unequal acceptance,
/// beside what Paper II claims.
Document modes_text(const Results& results);

}  // namespace wedgesim::reports
