#pragma once

#include <vector>

#include "reports/accuracy/measure.h"
#include "reports/sheet.h"

namespace wedgesim::reports::accuracy {

/// Differences from here on have full colour, in units of full light; smaller ones as the square
/// root of their share, so that 1/255 is seen, too.
inline constexpr double kFullColour = 0.25;
/// Saturation of a difference, 0 to 1.
double saturation_of(double error);

/// Visibility as grey, or as colours of a light that has them: the mean over the lights; the sky
/// is slate.
/// \param visibility  of each light, (height, width, channels)
Panel visibility_panel(const functional::DepthBuffer& depth,
                       const std::vector<std::vector<float>>& visibility);

/// Mean difference over lights and channels, visibility clamped to [0, 1]: red is too light, blue
/// too dark.
Panel difference_panel(const functional::DepthBuffer& depth,
                       const std::vector<std::vector<float>>& visibility,
                       const std::vector<std::vector<float>>& reference);

/// Signed errors as in difference_panel, (height, width); 0 for the sky.
std::vector<double> differences(const functional::DepthBuffer& depth,
                                const std::vector<std::vector<float>>& visibility,
                                const std::vector<std::vector<float>>& reference);

}  // namespace wedgesim::reports::accuracy
