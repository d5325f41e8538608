#pragma once

#include <cstdint>
#include <vector>

#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::reports::accuracy {

/// Of the reference's rays: not that of the method `raytraced`, which would be held against itself.
inline constexpr std::uint64_t kTruthSeed = 2;

/// Ray-traced visibility with many rays where it matters: a pixel whose 64 first rays, and those of
/// its eight neighbours, are all hidden or all not keeps that value; every other one gets `rays`.
/// \param rays  of a pixel in doubt; rounded down to a square number
/// \return (height, width, channels) as reference_visibility
std::vector<float> reference_where_it_matters(const functional::Scene& scene,
                                              const functional::Window& window,
                                              const functional::DepthBuffer& depth, int rays);

}  // namespace wedgesim::reports::accuracy
