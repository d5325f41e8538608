#include "functional/scene/light_texture.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/common.hpp>
#include <string_view>

#include "base/check.h"
#include "base/error.h"

namespace wedgesim::functional {
namespace {

constexpr int kMostTexels = 256;  // each way
constexpr int kRise = 8;  // cells of the coarsest turbulence that pass before the fire repeats

// A pseudo-random number of a lattice point, [0, 1]; `y` repeats after `period`.
double lattice(int x, int y, int period, std::uint32_t seed) {
  const int wrapped = (y % period + period) % period;
  std::uint32_t h = seed + 0x9e3779b9U * static_cast<std::uint32_t>(x + 4096) +
                    0x85ebca6bU * static_cast<std::uint32_t>(wrapped);
  h = (h ^ (h >> 16U)) * 0x7feb352dU;
  h = (h ^ (h >> 15U)) * 0x846ca68bU;
  return static_cast<double>((h ^ (h >> 16U)) >> 8U) / 16777215.0;
}

double noise(double x, double y, int period, std::uint32_t seed) {
  const auto smooth = [](double t) { return t * t * (3.0 - 2.0 * t); };
  const int i = static_cast<int>(std::floor(x));
  const int j = static_cast<int>(std::floor(y));
  const double u = smooth(x - i);
  const double low = glm::mix(lattice(i, j, period, seed), lattice(i + 1, j, period, seed), u);
  const double high =
      glm::mix(lattice(i, j + 1, period, seed), lattice(i + 1, j + 1, period, seed), u);
  return glm::mix(low, high, smooth(y - j));
}

// Three octaves, about 0, within ±0.5.
double turbulence(double x, double y, std::uint32_t seed) {
  double sum = 0.0;
  double weight = 0.5;
  int scale = 1;
  for (std::uint32_t octave = 0; octave < 3; ++octave) {
    sum += weight * (noise(scale * x, scale * y, kRise * scale, seed + octave) - 0.5);
    weight *= 0.5;
    scale *= 2;
  }
  return sum / 0.875;
}

// \param x     −1 to 1 across
// \param y     0 at the foot to 1 at the top
// \param time  0 to 1, once through
double heat(double x, double y, double time, std::uint32_t seed) {
  const double risen = kRise * time;
  const double sway = 0.9 * y * turbulence(1.5 * x + 31.0, 1.5 * y - risen, seed + 17);
  const double across = (x + sway) / (0.85 - 0.55 * y);
  const double flame = 1.15 * (1.0 - across * across) - 0.95 * y;
  return flame + 1.5 * (0.25 + y) * turbulence(3.0 * x, 2.0 * y - risen, seed);
}

// From black by red, orange and yellow: each colour sets in later.
glm::dvec3 glow(double heat) {
  const double h = std::clamp(heat, 0.0, 1.0);
  return {std::min(1.0, 1.8 * h), std::pow(h, 2.0), 0.7 * std::pow(h, 5.0)};
}

float decode_srgb(float value) {
  return value <= 0.04045F ? value / 12.92F : std::pow((value + 0.055F) / 1.055F, 2.4F);
}

}  // namespace

Image make_fire(int frame, int frames, int side, std::uint32_t seed) {
  CHECK_GE(side, 2);
  Image image(side, side, 3);
  const double time = static_cast<double>(frame) / frames;
  for (int row = 0; row < side; ++row) {
    for (int column = 0; column < side; ++column) {
      const double x = 2.0 * (column + 0.5) / side - 1.0;
      const double y = 1.0 - (row + 0.5) / side;
      const glm::dvec3 colour = glow(heat(x, y, time, seed));
      for (int c = 0; c < 3; ++c) image.pixel(column, row)[c] = static_cast<float>(colour[c]);
    }
  }
  return image;
}

Image read_light_texture(const std::filesystem::path& path) {
  const Image image = read_image(path);
  const auto refuse = [&](std::string_view problem, std::string_view expected) {
    throw InputError(path.string(), problem, expected);
  };
  if (std::max(image.width, image.height) > kMostTexels) {
    refuse(fmt::format("has {} x {} pixels", image.width, image.height),
           fmt::format("a light texture of at most {} each way", kMostTexels));
  }
  const bool grey = image.channels == 1;
  if (!grey && image.channels != 3 && image.channels != 4) {
    refuse(fmt::format("has {} channels", image.channels), "grey, RGB or RGBA");
  }
  Image texture(image.width, image.height, 3);
  float brightest = 0.0F;
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      for (int c = 0; c < 3; ++c) {
        const float value = image.pixel(x, y)[grey ? 0 : c];
        if (!(value >= 0.0F) || std::isinf(value)) {
          refuse(fmt::format("pixel ({}, {}) is {}", x, y, value), "finite values from 0");
        }
        texture.pixel(x, y)[c] = path.extension() == ".exr" ? value : decode_srgb(value);
        brightest = std::max(brightest, value);
      }
    }
  }
  if (brightest == 0.0F) refuse("is black", "a light texture that emits light");
  return texture;
}

Image emission_shares(const Image& texture) {
  CHECK_EQ(texture.channels, 3);
  Image shares = texture;
  for (std::size_t c = 0; c < 3; ++c) {
    double sum = 0.0;
    for (std::size_t i = c; i < shares.values.size(); i += 3) {
      sum += static_cast<double>(shares.values[i]);
    }
    const double even = 3.0 / static_cast<double>(shares.values.size());
    for (std::size_t i = c; i < shares.values.size(); i += 3) {
      const double value = sum > 0.0 ? static_cast<double>(shares.values[i]) / sum : even;
      shares.values[i] = static_cast<float>(value);
    }
  }
  return shares;
}

glm::dvec3 light_power(const Light& light) {
  if (!light.texture) return light.colour;
  const Image& texture = *light.texture;
  glm::dvec3 sum(0.0);
  for (std::size_t i = 0; i < texture.values.size(); i += 3) {
    for (int c = 0; c < 3; ++c) {
      sum[c] += static_cast<double>(texture.values[i + static_cast<std::size_t>(c)]);
    }
  }
  return light.colour * (sum * (3.0 / static_cast<double>(texture.values.size())));
}

}  // namespace wedgesim::functional
