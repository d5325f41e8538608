#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// The renderer that makes traces, in double precision (frame.h): what the others are checked with.
extern const Method kCoverage;
extern const Method kLinear;

}  // namespace wedgesim::functional
