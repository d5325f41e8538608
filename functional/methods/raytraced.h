#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Rays from every pixel's point to stratified samples of the light (reference.h).
extern const Method kRaytraced;

}  // namespace wedgesim::functional
