#include "reports/picture.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "base/check.h"
#include "base/error.h"
#include "functional/methods/render.h"

namespace wedgesim::reports {
namespace {

bool is_png(const std::filesystem::path& path) { return path.extension() == ".png"; }

// Stops of the map `inferno` (public domain), 8-bit sRGB: darker is always less.
constexpr std::array<std::array<float, 3>, 9> kHeat{{{0, 0, 4},
                                                     {31, 12, 72},
                                                     {85, 15, 109},
                                                     {136, 34, 106},
                                                     {186, 54, 85},
                                                     {227, 89, 51},
                                                     {249, 140, 10},
                                                     {249, 201, 50},
                                                     {252, 255, 164}}};

std::array<float, 3> heat_colour(float share) {
  const float at = std::clamp(share, 0.0F, 1.0F) * (kHeat.size() - 1);
  const auto low = std::min(static_cast<std::size_t>(at), kHeat.size() - 2);
  const float way = at - static_cast<float>(low);
  std::array<float, 3> colour{};
  for (std::size_t c = 0; c < 3; ++c) {
    colour[c] = std::lerp(kHeat[low][c], kHeat[low + 1][c], way) / 255.0F;
  }
  return colour;
}

Image image_of(std::span<const float> values, int width, int height) {
  const bool grey =
      values.size() == static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
  Image image(width, height, grey ? 1 : 3);
  CHECK_EQ(values.size(), image.values.size());
  std::ranges::copy(values, image.values.begin());
  return image;
}

}  // namespace

void require_image_name(const std::filesystem::path& path) {
  if (!is_png(path) && path.extension() != ".exr") {
    throw InputError(path.string(), "the image format is unknown", "a name ending in .png or .exr");
  }
}

void write_colours(const std::filesystem::path& path, const Image& linear) {
  write_image(path, is_png(path) ? functional::encode_srgb(linear) : linear);
}

void write_values(const std::filesystem::path& path, std::span<const float> values, int width,
                  int height) {
  write_image(path, image_of(values, width, height));
}

void write_heat(const std::filesystem::path& path, std::span<const float> values, int width,
                int height, float maximum) {
  if (!is_png(path)) return write_values(path, values, width, height);
  CHECK_GT(maximum, 0.0F);
  Image image(width, height, 3);
  CHECK_EQ(3 * values.size(), image.values.size());
  for (std::size_t i = 0; i < values.size(); ++i) {
    const std::array<float, 3> colour = heat_colour(values[i] / maximum);
    std::ranges::copy(colour, image.values.begin() + static_cast<std::ptrdiff_t>(3 * i));
  }
  write_image(path, image);
}

}  // namespace wedgesim::reports
