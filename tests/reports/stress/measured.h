#pragma once

#include <string_view>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// What a case's geometry is, in the unit of its family's difficulty.
using Measure = double (*)(const Case&);

/// How to measure a family's cases without knowing how they are made; null if there is no way.
Measure measure_of(std::string_view family);

}  // namespace wedgesim::reports::stress
