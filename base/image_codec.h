#pragma once

#include <string>
#include <vector>

#include "base/image.h"

namespace wedgesim {

/// How image files are encoded: the one thing that needs OpenImageIO. It is a module of its own,
/// loaded at the first image, because that library brings 250 others, a quarter of a second at
/// every start. Both return what went wrong, or nothing.
struct ImageCodec {
  /// 8 bits a channel (values clamped to [0, 1]), else 32-bit float; the format is the extension's.
  std::string (*write)(const std::string& path, const Image& image,
                       const std::vector<std::string>& channel_names, bool eight_bits);
  std::string (*read)(const std::string& path, Image& image);
};

/// The module's only symbol.
extern "C" const ImageCodec wedgesim_image_codec;

}  // namespace wedgesim
