#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include "functional/raster/depth_buffer.h"
#include "functional/scene/scene.h"

namespace wedgesim::reports::accuracy {

/// Parts of a frame that errors are measured on.
enum class Region { surfaces, receivers, casters, penumbra };
inline constexpr std::array kRegions{Region::surfaces, Region::receivers, Region::casters,
                                     Region::penumbra};
inline constexpr std::array<std::string_view, 4> kRegionNames{"surfaces", "receivers", "casters",
                                                              "penumbra"};
inline std::string_view name_of(Region region) {
  return kRegionNames[static_cast<std::size_t>(region)];
}

/// The error of visibility over a region, in units of full light. Visibility is clamped to [0, 1]
/// first, as a display does.
struct Errors {
  std::size_t values = 0;  // compared: pixels times channels; all else is 0 if there are none
  double rmse = 0.0;
  double largest = 0.0;
  double beyond_1_255 = 0.0;   // share of the values that are off by more, [0, 1]
  double beyond_16_255 = 0.0;  // and by more than 16/255
  double wrong_kind = 0.0;     // share of values that are umbra, penumbra or lit where the
                               // reference is another of these: where boundaries lie wrong

  /// 20 log₁₀(1 / rmse), decibels; infinity without an error.
  double psnr_db() const;
};

/// Which region each pixel is of, by the surface that is seen and by the reference.
class Regions {
 public:
  /// \param reference  (height, width, channels) visibility; penumbra: between 0 and 1 in a channel
  Regions(const functional::Scene& scene, const functional::DepthBuffer& depth,
          std::span<const float> reference);
  bool holds(Region region, std::size_t pixel) const {
    return (bits_[pixel] >> static_cast<unsigned>(region) & 1U) != 0;
  }

 private:
  std::vector<std::uint8_t> bits_;  // (height, width)
};

/// Sums up errors; frames may be added one after the other.
class ErrorSum {
 public:
  /// \param values, reference  (height, width, channels)
  void add(const Regions& regions, Region region, std::span<const float> values,
           std::span<const float> reference, std::size_t pixels);
  Errors errors() const;

 private:
  std::size_t values_ = 0;
  double squares_ = 0.0;
  double largest_ = 0.0;
  std::size_t beyond_1_ = 0;
  std::size_t beyond_16_ = 0;
  std::size_t wrong_kind_ = 0;
};

}  // namespace wedgesim::reports::accuracy
