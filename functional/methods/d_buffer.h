#pragma once

#include "functional/methods/method.h"

namespace wedgesim::functional {

/// Soft shadows with right boundaries from a disk light: distances to umbra and penumbra volumes,
/// kept in a map seen from the light's centre (Jakobsen et al. 2004; seed 002).
extern const Method kDBuffer;

}  // namespace wedgesim::functional
