#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Hard-shadow silhouettes of several light samples on a planar receiver, merged into rings.
extern const Method kSilhouetteRings;

}  // namespace wedgesim::functional
