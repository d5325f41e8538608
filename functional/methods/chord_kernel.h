#pragma once

#include <array>
#include <functional>
#include <glm/vec2.hpp>

#include "functional/raster/volume_raster.h"
#include "functional/scene/scene.h"

namespace wedgesim::functional {

/// What a chord of a rectangular light hides, of each channel.
using ChordLookup = std::function<std::array<float, 3>(const glm::dvec2& p, const glm::dvec2& q)>;

/// The kernel that looks up what edges hide by the chords they project to.
/// \param channels  1 or 3
DrawRow chord_kernel(ChordLookup lookup, int channels);

/// Kernels for words of 8 bits (split_word.h), in three channels: what wedges add and what they
/// take, from 1 on, each contribution rounded to a ShortWord, in 1/64; and the umbra.
DrawRow short_chord_kernel(ChordLookup lookup);
DrawRow short_coverage_kernel(LightShape shape);

}  // namespace wedgesim::functional
