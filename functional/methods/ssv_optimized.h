#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Soft shadow volumes with tight wedges, the overlap heuristic and light splitting.
extern const Method kSsvOptimized;

}  // namespace wedgesim::functional
