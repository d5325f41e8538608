#pragma once

#include <filesystem>
#include <string>

#include "base/image.h"

namespace wedgesim::reports::page {

/// The mean of each square of pixels.
/// \param most_width  of what comes out
Image reduced(const Image& image, int most_width);

/// The bytes of a PNG (write_image), with one channel if three are the same everywhere.
/// \param scratch  a file that is written and removed
std::string png_of(const Image& image, const std::filesystem::path& scratch);

}  // namespace wedgesim::reports::page
