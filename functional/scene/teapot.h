#pragma once

#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// A teapot in the manner of Newell's: body and lid turned on the lathe from the published profile
/// curves, spout and handle swept along curves of our own. Four closed surfaces that reach into
/// each other: a receiver, or a caster whose shadows overlap. The spout points along +x.
/// \param height    from the table, y = 0, to the tip of the lid
/// \param segments  round the axis, at least 3; also sets the steps along the curves
Mesh make_teapot(double height, int segments);

}  // namespace wedgesim::functional
