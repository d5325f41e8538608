#include "functional/raster/depth_image.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <glm/geometric.hpp>

#include "base/error.h"

namespace wedgesim::functional {
namespace {

constexpr double kRounding = 1e-6;  // of a renderer that stores 1.0000001

struct Limits {
  double low, high;
  const char* expected;
};

Limits limits_of(DepthMeaning meaning) {
  switch (meaning) {
    case DepthMeaning::window:
    case DepthMeaning::reversed:
      return {-kRounding, 1.0 + kRounding, "window depth from 0 to 1, or another --meaning"};
    case DepthMeaning::ndc:
      return {-1.0 - kRounding, 1.0 + kRounding, "depth from -1 to 1, or another --meaning"};
    case DepthMeaning::view:
    case DepthMeaning::distance:
      return {0.0, HUGE_VAL, "a distance above 0, or another --meaning"};
  }
  return {0.0, 0.0, ""};
}

}  // namespace

DepthBuffer depth_of_image(const Image& image, std::size_t channel, DepthMeaning meaning,
                           const Window& window, traces::fb::DepthFormat format,
                           const std::string& place) {
  if (image.width != window.width || image.height != window.height) {
    throw InputError(place, fmt::format("is {}x{} pixels", image.width, image.height),
                     fmt::format("{}x{}, the scene's size, or --size {}x{}", window.width,
                                 window.height, image.width, image.height));
  }
  const Limits limits = limits_of(meaning);
  const glm::dvec3 ahead = forward(window);
  DepthBuffer depth;
  depth.format = format;
  depth.width = window.width;
  depth.height = window.height;
  depth.words.reserve(image.values.size());
  for (int y = 0; y < image.height; ++y) {
    for (int x = 0; x < image.width; ++x) {
      const double value = image.pixel(x, y)[channel];
      const bool distance = limits.high == HUGE_VAL;
      if (!(value >= limits.low && value <= limits.high) || (distance && value == 0.0)) {
        throw InputError(fmt::format("{}: pixel {},{}", place, x, y),
                         fmt::format("its value is {:g}", value), limits.expected);
      }
      double z = value;
      if (meaning == DepthMeaning::reversed) z = 1.0 - value;
      if (meaning == DepthMeaning::ndc) z = 0.5 * (value + 1.0);
      if (distance) {
        double along = value;
        if (meaning == DepthMeaning::distance) {
          const glm::dvec3 ray = world_point(window, x + 0.5, y + 0.5, 0.0) - window.eye;
          along *= glm::dot(ray, ahead) / glm::length(ray);
        }
        z = window_depth(window, along);  // infinity, too: beyond 1
        if (z < -kRounding) {
          throw InputError(fmt::format("{}: pixel {},{}", place, x, y),
                           fmt::format("{:g} is before the near plane", value),
                           "a camera whose 'near' is nearer");
        }
      }
      depth.words.push_back(traces::encode_depth(format, z));
    }
  }
  return depth;
}

std::size_t depth_channel(const Image& image, const std::string& name, const std::string& place) {
  const std::vector<std::string>& names = image.channel_names;
  const auto find = [&names](const std::string& wanted) {
    return static_cast<std::size_t>(std::ranges::find(names, wanted) - names.begin());
  };
  if (!name.empty()) {
    if (find(name) < names.size()) return find(name);
    throw InputError(place, fmt::format("has no channel '{}'", name),
                     fmt::format("one of {}", fmt::join(names, ", ")));
  }
  if (image.channels == 1) return 0;
  for (const char* usual : {"Z", "depth.Z", "Depth.Z", "depth", "Depth", "Y", "V"}) {
    if (find(usual) < names.size()) return find(usual);
  }
  throw InputError(place, fmt::format("has {} channels and none called Z", image.channels),
                   fmt::format("--channel, one of {}", fmt::join(names, ", ")));
}

Image flipped(const Image& image) {
  Image turned = image;
  const auto row = static_cast<std::ptrdiff_t>(image.width) * image.channels;
  for (int y = 0; y < image.height; ++y) {
    std::copy_n(image.values.begin() + row * y, row,
                turned.values.begin() + row * (image.height - 1 - y));
  }
  return turned;
}

}  // namespace wedgesim::functional
