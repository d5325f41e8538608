#pragma once

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The mesh with equal positions made one vertex, in the order of first appearance; vertices of no
/// triangle go. No triangle goes and none moves. -0 and 0 are equal.
Mesh welded(const Mesh& mesh);

}  // namespace wedgesim::functional
