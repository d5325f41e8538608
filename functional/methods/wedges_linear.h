#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Penumbra wedges by interpolation: of entry and exit points, and restructured.
extern const Method kWedge2002;
extern const Method kWedgeRestructured;

}  // namespace wedgesim::functional
