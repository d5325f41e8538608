#include "reports/page/small_picture.h"

#include <algorithm>

#include "base/file.h"

namespace wedgesim::reports::page {
namespace {

bool is_grey(const Image& image) {
  if (image.channels != 3) return false;
  for (std::size_t i = 0; i < image.values.size(); i += 3) {
    if (image.values[i] != image.values[i + 1] || image.values[i] != image.values[i + 2]) {
      return false;
    }
  }
  return true;
}

Image first_channel(const Image& image) {
  Image first(image.width, image.height, 1);
  for (std::size_t i = 0; i < first.values.size(); ++i) first.values[i] = image.values[3 * i];
  return first;
}

}  // namespace

Image reduced(const Image& image, int most_width) {
  const int step = (image.width + most_width - 1) / most_width;
  Image small((image.width + step - 1) / step, (image.height + step - 1) / step, image.channels);
  for (int y = 0; y < small.height; ++y) {
    for (int x = 0; x < small.width; ++x) {
      const int x_end = std::min((x + 1) * step, image.width);
      const int y_end = std::min((y + 1) * step, image.height);
      const auto pixels = static_cast<float>((x_end - x * step) * (y_end - y * step));
      for (int j = y * step; j < y_end; ++j) {
        for (int i = x * step; i < x_end; ++i) {
          for (int c = 0; c < image.channels; ++c) {
            small.pixel(x, y)[c] += image.pixel(i, j)[c] / pixels;
          }
        }
      }
    }
  }
  return small;
}

std::string png_of(const Image& image, const std::filesystem::path& scratch) {
  write_image(scratch, is_grey(image) ? first_channel(image) : image);
  std::string bytes(MappedFile(scratch).text());
  std::filesystem::remove(scratch);
  return bytes;
}

}  // namespace wedgesim::reports::page
