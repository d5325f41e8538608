#include "base/image_codec.h"

#include <OpenImageIO/imageio.h>

namespace wedgesim {
namespace {

std::string write(const std::string& path, const Image& image,
                  const std::vector<std::string>& channel_names, bool eight_bits) {
  OIIO::ImageSpec spec(image.width, image.height, image.channels,
                       eight_bits ? OIIO::TypeDesc::UINT8 : OIIO::TypeDesc::FLOAT);
  if (!channel_names.empty()) spec.channelnames = channel_names;
  spec.attribute("oiio:ColorSpace", eight_bits ? "sRGB" : "Linear");
  spec.attribute("DateTime", "2000:01:01 00:00:00");  // the same bytes at every run
  const auto out = OIIO::ImageOutput::create(path);
  if (!out) return OIIO::geterror();
  if (!out->open(path, spec) || !out->write_image(OIIO::TypeDesc::FLOAT, image.values.data()) ||
      !out->close()) {
    return out->geterror();  // unread it would be printed at the end
  }
  return {};
}

std::string read(const std::string& path, Image& image) {
  const auto in = OIIO::ImageInput::open(path);
  if (!in) return OIIO::geterror();
  const OIIO::ImageSpec& spec = in->spec();
  image = Image(spec.width, spec.height, spec.nchannels);
  image.channel_names = spec.channelnames;
  if (!in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data())) {
    return in->geterror();
  }
  return {};
}

}  // namespace

extern "C" const ImageCodec wedgesim_image_codec{write, read};

}  // namespace wedgesim
