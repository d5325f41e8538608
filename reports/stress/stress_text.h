#pragma once

#include <string>
#include <vector>

#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// How far each family holds in each arithmetic, and what is wrong.
std::string stress_text(const std::vector<FamilyResult>& results);

/// Every level of one family.
std::string levels_text(const FamilyResult& result);

}  // namespace wedgesim::reports::stress
