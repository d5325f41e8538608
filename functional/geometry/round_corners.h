#pragma once

#include <glm/vec3.hpp>
#include <vector>

namespace wedgesim::functional {

/// A loop with the corners that are acute as the light sees them cut by short edges, more for
/// sharper ones, up to 6: the extra wedges that Paper I, 4.1 puts around such a corner.
/// \param loop  corners in order, world space
/// \return      the loop with each corner below 75° replaced by points within a thousandth of its
///              shorter edge from it
std::vector<glm::dvec3> round_corners(const std::vector<glm::dvec3>& loop,
                                      const glm::dvec3& light_centre);

}  // namespace wedgesim::functional
