#pragma once

#include <filesystem>
#include <span>

#include "base/image.h"

namespace wedgesim::reports {

/// \throws InputError unless the name ends in .png or .exr: known before long work, not after
void require_image_name(const std::filesystem::path& path);

/// Writes linear colours: PNG along the sRGB curve, EXR as they are.
void write_colours(const std::filesystem::path& path, const Image& linear);

/// Writes one value a pixel, or three: PNG as grey or RGB, clamped to [0, 1] and proportional, EXR
/// as it is.
/// \param values  (height, width) or (height, width, 3)
void write_values(const std::filesystem::path& path, std::span<const float> values, int width,
                  int height);

/// Writes one value a pixel, 0 and above: PNG in false colours from black (0) to pale yellow (the
/// scale's maximum and beyond), EXR as it is.
/// \param values  (height, width)
void write_heat(const std::filesystem::path& path, std::span<const float> values, int width,
                int height, float maximum);

}  // namespace wedgesim::reports
