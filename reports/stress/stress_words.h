#pragma once

#include <string>
#include <vector>

#include "reports/stress/run.h"

namespace wedgesim::reports::stress {

/// How far each arithmetic holds in a family: "fixed holds to 1e-4 (must: 1e-3), ...".
std::string bounds_words(const FamilyResult& result);
/// What was refused in a family, and from where; empty if nothing was.
std::string refused_words(const FamilyResult& result);
/// Why a case does not hold.
std::string broken_words(const Errors& errors);
/// What all families together say, a sentence each.
std::vector<std::string> finding_words(const std::vector<FamilyResult>& results);

}  // namespace wedgesim::reports::stress
