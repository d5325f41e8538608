#pragma once

#include <vector>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// The families, by what is extreme about them.
std::vector<Family> edge_families();
std::vector<Family> light_families();

}  // namespace wedgesim::reports::stress
