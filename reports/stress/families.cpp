#include <algorithm>
#include <iterator>

#include "reports/stress/families/groups.h"
#include "reports/stress/family.h"

namespace wedgesim::reports::stress {

std::span<const Family> families() {
  static const std::vector<Family> all = [] {
    std::vector<Family> result;
    for (const auto& group :
         {edge_families, light_families, receiver_families, depth_range_families,
          placement_families, eye_families, count_families, raster_families, found_families}) {
      std::ranges::move(group(), std::back_inserter(result));
    }
    return result;
  }();
  return all;
}

}  // namespace wedgesim::reports::stress
