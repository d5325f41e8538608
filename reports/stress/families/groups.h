#pragma once

#include <vector>

#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

/// The families, by what is extreme about them.
std::vector<Family> edge_families();
std::vector<Family> light_families();
std::vector<Family> receiver_families();
std::vector<Family> depth_range_families();
std::vector<Family> placement_families();
std::vector<Family> eye_families();
std::vector<Family> count_families();
std::vector<Family> raster_families();
/// Frames that the random search has found failing.
std::vector<Family> found_families();

}  // namespace wedgesim::reports::stress
