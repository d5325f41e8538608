#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Soft shadow volumes with exact coverage of rectangular and spherical lights.
extern const Method kSsv;

}  // namespace wedgesim::functional
