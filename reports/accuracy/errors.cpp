#include "reports/accuracy/errors.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "base/check.h"

namespace wedgesim::reports::accuracy {
namespace {

enum class Kind { umbra, penumbra, lit };
Kind kind_of(double visible) {
  constexpr double kNone = 0.5 / 255.0;  // what an 8-bit buffer shows as nothing
  return visible < kNone ? Kind::umbra : visible > 1.0 - kNone ? Kind::lit : Kind::penumbra;
}

}  // namespace

using functional::DepthBuffer;

double Errors::psnr_db() const {
  return rmse > 0.0 ? -20.0 * std::log10(rmse) : std::numeric_limits<double>::infinity();
}

Regions::Regions(const functional::Scene& scene, const DepthBuffer& depth,
                 std::span<const float> reference)
    : bits_(depth.words.size()) {
  const auto bit = [](Region region) {
    return static_cast<std::uint8_t>(1U << static_cast<unsigned>(region));
  };
  const std::size_t channels = reference.size() / bits_.size();
  CHECK_EQ(channels * bits_.size(), reference.size());
  for (std::size_t i = 0; i < bits_.size(); ++i) {
    if (depth.triangle[i] == DepthBuffer::kSky) continue;
    const bool casts = scene.objects[depth.surface(i).object].casts;
    const bool penumbra = std::ranges::any_of(reference.subspan(i * channels, channels),
                                              [](float v) { return v > 0.0F && v < 1.0F; });
    bits_[i] = static_cast<std::uint8_t>(bit(Region::surfaces) |
                                         bit(casts ? Region::casters : Region::receivers) |
                                         (penumbra ? bit(Region::penumbra) : 0));
  }
}

void ErrorSum::add(const Regions& regions, Region region, std::span<const float> values,
                   std::span<const float> reference, std::size_t pixels) {
  CHECK_EQ(values.size(), reference.size());
  const std::size_t channels = values.size() / pixels;
  for (std::size_t i = 0; i < pixels; ++i) {
    if (!regions.holds(region, i)) continue;
    for (std::size_t k = i * channels; k < (i + 1) * channels; ++k) {
      const double shown = std::clamp(static_cast<double>(values[k]), 0.0, 1.0);
      const auto truth = static_cast<double>(reference[k]);
      const double error = std::abs(shown - truth);
      ++values_;
      squares_ += error * error;
      largest_ = std::max(largest_, error);
      if (error > 1.0 / 255.0) ++beyond_1_;
      if (error > 16.0 / 255.0) ++beyond_16_;
      if (kind_of(shown) != kind_of(truth)) ++wrong_kind_;
    }
  }
}

Errors ErrorSum::errors() const {
  if (values_ == 0) return {};
  const auto n = static_cast<double>(values_);
  return {.values = values_,
          .rmse = std::sqrt(squares_ / n),
          .largest = largest_,
          .beyond_1_255 = static_cast<double>(beyond_1_) / n,
          .beyond_16_255 = static_cast<double>(beyond_16_) / n,
          .wrong_kind = static_cast<double>(wrong_kind_) / n};
}

}  // namespace wedgesim::reports::accuracy
