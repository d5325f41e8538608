#include "base/image.h"

#include <dlfcn.h>

#include "base/error.h"
#include "base/file.h"
#include "base/image_codec.h"

namespace wedgesim {
namespace {

const ImageCodec& codec() {
  static const ImageCodec& loaded = []() -> const ImageCodec& {
    void* module = dlopen(WEDGESIM_IMAGE_CODEC, RTLD_NOW | RTLD_LOCAL);
    const void* symbol = module ? dlsym(module, "wedgesim_image_codec") : nullptr;
    if (!symbol) {
      throw InputError(WEDGESIM_IMAGE_CODEC, dlerror(), "the module that was built with it");
    }
    return *static_cast<const ImageCodec*>(symbol);
  }();
  return loaded;
}

}  // namespace

void write_image(const std::filesystem::path& path, const Image& image,
                 const std::vector<std::string>& channel_names) {
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".exr") {
    throw InputError(path.string(), "the image format is unknown", "a name ending in .png or .exr");
  }
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    const std::string problem =
        codec().write(temporary.string(), image, channel_names, extension == ".png");
    // The codec's own words name the temporary file.
    if (!problem.empty()) {
      throw InputError(path.string(), "cannot be written", "a writable folder with room");
    }
  });
}

Image read_image(const std::filesystem::path& path) {
  Image image;
  const std::string problem = codec().read(path.string(), image);
  if (!problem.empty()) throw InputError(path.string(), problem, "a readable image");
  return image;
}

}  // namespace wedgesim
