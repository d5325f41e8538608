#pragma once

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace wedgesim {

/// Pixels of `channels` floats each, rows from the top, values linear.
struct Image {
  int width = 0;
  int height = 0;
  int channels = 1;
  std::vector<float> values;               // height × width × channels
  std::vector<std::string> channel_names;  // of an image that was read, one a channel

  Image() = default;
  Image(int w, int h, int c)
      : width(w),
        height(h),
        channels(c),
        values(static_cast<std::size_t>(w) * static_cast<std::size_t>(h) *
               static_cast<std::size_t>(c)) {}
  float* pixel(int x, int y) { return values.data() + offset(x, y); }
  const float* pixel(int x, int y) const { return values.data() + offset(x, y); }

 private:
  std::size_t offset(int x, int y) const {
    return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) +
            static_cast<std::size_t>(x)) *
           static_cast<std::size_t>(channels);
  }
};

/// Writes by the extension: PNG as 8 bits a channel (values clamped to [0, 1] and stored as they
/// are), EXR as 32-bit float. Same values, same bytes. Whole or not at all.
/// \throws InputError if the extension is unknown or the file cannot be written
void write_image(const std::filesystem::path& path, const Image& image,
                 const std::vector<std::string>& channel_names = {});

/// Reads PNG, EXR or anything OpenImageIO knows; integers are scaled to [0, 1].
/// \throws InputError if the file cannot be read as an image
Image read_image(const std::filesystem::path& path);

}  // namespace wedgesim
