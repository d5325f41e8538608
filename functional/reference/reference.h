#pragma once

#include <cstdint>
#include <span>
#include <vector>

#include "functional/raster/depth_buffer.h"
#include "functional/raster/window.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// Ray-traced visibility, the truth that the shadow methods are measured against.
/// For each pixel the visible fraction of the light: rays from the stored surface point to
/// stratified samples of the light, one per cell, jittered by a hash of pixel and sample, against
/// the casters alone (Embree, robust mode). From a caster they start on its triangle; what is
/// behind the triangle's plane is hidden by the caster itself. A rectangle is sampled over its
/// area, a sphere over the disc that the tangent cone from the point cuts (coverage.h).
/// A light with a texture is sampled in each texel, and each sample counts as much as its texel
/// emits of the power of each colour.
/// \param samples  rounded down to a square number, at least 1; with a texture, rounded up so that
///                 each texel has as many each way
/// \param wanted  (height, width) which pixels are traced, not 0; empty: all
/// \return (height, width) visibility in [0, 1], or with a texture (height, width, 3); 1 for the
///         sky and for pixels that are not wanted
std::vector<float> reference_visibility(const Scene& scene, const Window& window,
                                        const DepthBuffer& depth, int samples = 1024,
                                        std::uint64_t seed = 1,
                                        std::span<const std::uint8_t> wanted = {});

}  // namespace wedgesim::functional
