#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Hard shadow volumes: one from the light's centre; the average of many from points of the light.
extern const Method kHard;
extern const Method kSampled;

}  // namespace wedgesim::functional
