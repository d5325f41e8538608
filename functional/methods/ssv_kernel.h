#pragma once

#include "functional/raster/volume_raster.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The kernel that draws hard shadow volumes alone.
DrawRow hard_kernel();
/// The kernel of a light's shape: exact clipping; of a point, as hard_kernel.
DrawRow coverage_kernel(LightShape shape);
/// The kernels of linear wedges: Paper I's entry and exit points, and Paper II's points alone.
/// \param cubic  3s² - 2s³ of the intensity
DrawRow entry_exit_kernel(bool cubic);
DrawRow restructured_kernel(bool cubic);

}  // namespace wedgesim::functional
