#pragma once

#include <map>
#include <string_view>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// What a case's geometry is, in the unit of its family's difficulty.
using Measure = double (*)(const Case&);

/// By family, how to measure its cases without knowing how they are made: from the caster and the
/// light, and from the frame and the eye. Families of neither have no such measure.
std::map<std::string_view, Measure> caster_measures();
std::map<std::string_view, Measure> view_measures();

}  // namespace wedgesim::reports::stress
