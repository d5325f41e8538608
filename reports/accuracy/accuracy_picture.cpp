#include "reports/accuracy/accuracy_picture.h"

#include <algorithm>
#include <cmath>

namespace wedgesim::reports::accuracy {
namespace {

using functional::DepthBuffer;

bool is_sky(const DepthBuffer& depth, std::size_t pixel) {
  return depth.triangle[pixel] == DepthBuffer::kSky;
}

}  // namespace

double saturation_of(double error) {
  return std::sqrt(std::min(std::fabs(error) / kFullColour, 1.0));
}

Panel visibility_panel(const DepthBuffer& depth,
                       const std::vector<std::vector<float>>& visibility) {
  const auto lights = static_cast<double>(visibility.size());
  Panel panel;
  for (std::size_t i = 0; i < depth.words.size(); ++i) {
    std::array<double, 3> sum{};
    for (const std::vector<float>& values : visibility) {
      const std::size_t channels = values.size() / depth.words.size();
      for (std::size_t c = 0; c < 3; ++c) {
        const double value = static_cast<double>(values[i * channels + std::min(c, channels - 1)]);
        sum[c] += std::clamp(value, 0.0, 1.0) / lights;
      }
    }
    const Colour colour{grey_of(sum[0])[0], grey_of(sum[1])[1], grey_of(sum[2])[2]};
    panel.push_back(is_sky(depth, i) ? kSky : colour);
  }
  return panel;
}

std::vector<double> differences(const DepthBuffer& depth,
                                const std::vector<std::vector<float>>& visibility,
                                const std::vector<std::vector<float>>& reference) {
  std::vector<double> errors(depth.words.size());
  for (std::size_t light = 0; light < visibility.size(); ++light) {
    const std::vector<float>& values = visibility[light];
    const std::size_t channels = values.size() / errors.size();
    const auto count = static_cast<double>(channels * visibility.size());
    for (std::size_t i = 0; i < values.size(); ++i) {
      if (is_sky(depth, i / channels)) continue;
      errors[i / channels] += (std::clamp(static_cast<double>(values[i]), 0.0, 1.0) -
                               static_cast<double>(reference[light][i])) /
                              count;
    }
  }
  return errors;
}

Panel difference_panel(const DepthBuffer& depth, const std::vector<std::vector<float>>& visibility,
                       const std::vector<std::vector<float>>& reference) {
  const std::vector<double> errors = differences(depth, visibility, reference);
  Panel panel;
  for (std::size_t i = 0; i < errors.size(); ++i) {
    panel.push_back(is_sky(depth, i) ? kSky
                                     : difference_colour(errors[i], saturation_of(errors[i])));
  }
  return panel;
}

}  // namespace wedgesim::reports::accuracy
