#pragma once

#include <span>

#include "base/image.h"
#include "reports/stress/measure.h"

namespace wedgesim::reports::stress {

/// A row for each arithmetic: the judge's LI, the arithmetic's, and their difference; of frames
/// much wider or higher than that all panels below or beside each other. LI is grey, magenta where
/// it is no number, the sky is slate. Differences go from white over pale to blue (too dark) or red
/// (too light) at the bar; beyond it they are full blue or red, in a black box if pixels are drawn
/// large enough. Values for a PNG, sRGB.
/// \param measurement  with its pictures
/// \param scale  a pixel's edge in the picture, at least 1
Image picture_of(const Measurement& measurement, std::span<const Arithmetic> arithmetics,
                 int scale);

/// A scale at which a frame is visible.
int visible_scale(const Measurement& measurement);

}  // namespace wedgesim::reports::stress
