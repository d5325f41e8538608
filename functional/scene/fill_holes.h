#pragma once

#include <cstddef>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

struct FilledHoles {
  std::size_t holes = 0;
  std::size_t triangles = 0;
};

/// Closes each hole whose edge is a simple loop, at most `tolerance` from a plane, by triangles
/// over its corners that run the way the mesh does there. Other holes stay.
/// \param tolerance  world units
FilledHoles fill_planar_holes(Mesh& mesh, double tolerance);

}  // namespace wedgesim::functional
