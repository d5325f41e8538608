#pragma once

#include "functional/raster/volume_raster.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The kernel that draws hard shadow volumes alone.
DrawRow hard_kernel();
/// The kernel of a light's shape: exact clipping; of a point, as hard_kernel.
DrawRow coverage_kernel(LightShape shape);

}  // namespace wedgesim::functional
