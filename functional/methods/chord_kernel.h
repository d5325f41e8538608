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

/// Kernels for words of 8 bits (split_word.h): 3 channels, to which wedges add, what they add in
/// one and what they take in the next, each contribution rounded to a ShortWord, in 1/64. The third
/// has the umbra alone.
DrawRow short_chord_kernel(ChordLookup lookup);
DrawRow short_coverage_kernel(LightShape shape);

/// The same for words over four 8-bit components (split_word.h): 9 channels, of what wedges add the
/// four components, in 1/256, of what they take the four, and the umbra alone.
DrawRow split_chord_kernel(ChordLookup lookup);
DrawRow split_coverage_kernel(LightShape shape);

}  // namespace wedgesim::functional
