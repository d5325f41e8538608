#pragma once

#include <memory>

#include "functional/light/coverage_texture.h"
#include "functional/light/emission.h"
#include "functional/raster/volume_raster.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// The kernel that looks up what edges hide of a rectangular light; as many channels as the table.
DrawRow texture_kernel(std::shared_ptr<const CoverageTexture> table, TextureFilter filter);

/// The kernel of a light with a texture by exact clipping: three channels.
DrawRow emission_kernel(Emission emission);

/// Kernels for words of 8 bits (split_word.h), in three channels: what wedges add and what they
/// take, from 1 on, each contribution rounded to a ShortWord, in 1/64; and the umbra.
/// \param table  of one channel
DrawRow short_texture_kernel(std::shared_ptr<const CoverageTexture> table, TextureFilter filter);
DrawRow short_coverage_kernel(LightShape shape);

}  // namespace wedgesim::functional
