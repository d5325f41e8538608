#pragma once

#include <cstdint>
#include <vector>

#include "functional/geometry/silhouette.h"

namespace wedgesim::functional {

/// Which silhouette loops of a caster shadow together: each loop around a shadow starts a group, a
/// loop around a hole of it joins it. The smallest loop around holds the hole, as seen from the
/// light; a hole in none is in the first group.
/// \return  of each loop its group, from 0 without gaps
std::vector<std::uint32_t> loop_groups(const Mesh& mesh, const Silhouette& silhouette,
                                       const glm::dvec3& light_centre);

}  // namespace wedgesim::functional
