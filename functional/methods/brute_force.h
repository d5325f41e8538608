#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include "functional/methods/shadow_geometry.h"
#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"

namespace wedgesim::functional {

/// The witness of evaluate_light_intensity: the same light intensity without a snapped polygon, by
/// every wedge at every pixel asked for.
/// coverage  1, minus 1 for each light-facing triangle between the point and the light's centre,
///           plus or minus the covered fraction of every silhouette edge, inside its wedge or not.
/// linear    1, minus the front faces that the view ray crosses (unsnapped, so z-pass frames
///           alone), plus the intensity of every wedge whose planes hold the point.
/// \param pixels  indices into the frame, row-major
/// \return light intensity of each, not clamped; 1 for the sky
std::vector<double> brute_force_light_intensity(const Scene& scene, const Window& window,
                                                const DepthBuffer& depth,
                                                const ShadowGeometry& geometry,
                                                std::span<const std::size_t> pixels);

}  // namespace wedgesim::functional
