#pragma once

#include <string>
#include <vector>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// How far a repair may go; lengths in parts of the bounding box's diagonal.
struct RepairLimits {
  double weld = 1e-5;    // vertices this near become one
  double planar = 1e-4;  // holes whose corners stray this little from a plane are closed
};

/// Does what is safe to close a mesh, in this order: welds vertices, drops degenerate and duplicate
/// triangles, turns triangles the way their neighbours run, closes planar holes, turns components
/// outwards. Adds no vertices.
/// \param notes  gets one line for each step that changed something
/// \return the mesh, which may still not be closed: ask examine() or require_closed()
Mesh repaired(const Mesh& mesh, std::vector<std::string>& notes, const RepairLimits& limits = {});

}  // namespace wedgesim::functional
