#pragma once

#include <filesystem>
#include <vector>

#include "reports/accuracy/measure.h"

namespace wedgesim::reports::accuracy::tests {

/// Made-up results of scenes of 60x40 pixels: a strip of sky above a floor with a round shadow,
/// `choices` choices on each, first one of each method, then raytraced-N. Choice k is
/// 1.5 times slower than the one before and 0.7 times as wrong, but for every third, which is
/// slower and more wrong; it is too light by its error at the left and too dark at the right. The
/// last choice is refused. Scene 0 and 1 have the same name; words hold HTML.
std::vector<SceneResult> sample_scenes(std::size_t scenes, std::size_t choices);

/// Writes their page, JSON and pictures, with the artifact of `hard`.
void write_sample(const std::filesystem::path& folder, const std::vector<SceneResult>& scenes);

}  // namespace wedgesim::reports::accuracy::tests
