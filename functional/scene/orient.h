#pragma once

#include <cstddef>

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Turns triangles until neighbours run along their common edge in opposite directions. Neighbours
/// are two triangles that alone share an edge; each component keeps the way that most of its
/// triangles ran. A one-sided component stays inconsistent.
/// \return how many triangles were turned
std::size_t orient_alike(Mesh& mesh);

/// Turns every component whose signed volume is negative.
/// \return how many components were turned
std::size_t orient_outwards(Mesh& mesh);

}  // namespace wedgesim::functional
