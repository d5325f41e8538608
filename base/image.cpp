#include "base/image.h"

#include <OpenImageIO/imageio.h>

#include "base/error.h"
#include "base/file.h"

namespace wedgesim {

void write_image(const std::filesystem::path& path, const Image& image,
                 const std::vector<std::string>& channel_names) {
  const std::string extension = path.extension().string();
  if (extension != ".png" && extension != ".exr") {
    throw InputError(path.string(), "the image format is unknown", "a name ending in .png or .exr");
  }
  write_atomically(path, [&](const std::filesystem::path& temporary) {
    OIIO::ImageSpec spec(image.width, image.height, image.channels,
                         extension == ".png" ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
    if (!channel_names.empty()) spec.channelnames = channel_names;
    spec.attribute("oiio:ColorSpace", extension == ".png" ? "sRGB" : "Linear");
    spec.attribute("DateTime", "2000:01:01 00:00:00");  // the same bytes at every run
    const auto out = OIIO::ImageOutput::create(temporary.string());
    if (!out || !out->open(temporary.string(), spec) ||
        !out->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) || !out->close()) {
      // OpenImageIO's own words name the temporary file; unread they would be printed at the end.
      static_cast<void>(out ? out->geterror() : OIIO::geterror());
      throw InputError(path.string(), "cannot be written", "a writable folder with room");
    }
  });
}

Image read_image(const std::filesystem::path& path) {
  const auto in = OIIO::ImageInput::open(path.string());
  if (!in) throw InputError(path.string(), OIIO::geterror(), "a readable image");
  const OIIO::ImageSpec& spec = in->spec();
  Image image(spec.width, spec.height, spec.nchannels);
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data())) {
    throw InputError(path.string(), in->geterror(), "a readable image");
  }
  return image;
}

}  // namespace wedgesim
