#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "functional/methods/penumbra_strips.h"
#include "functional/raster/clip.h"

namespace wedgesim::functional {

/// What a texel of a distortion map names: a strip, and whether its edge or its begin is nearest.
struct StripName {
  enum class Part : std::uint32_t { edge, outer_corner, inner_corner };
  static constexpr std::uint32_t kNone = 0xffffffffU;
  std::uint32_t word = kNone;

  static StripName of(std::size_t strip, Part part) {
    return {4 * static_cast<std::uint32_t>(strip) + static_cast<std::uint32_t>(part)};
  }
  bool operator==(const StripName&) const = default;
  bool exists() const { return word != kNone; }
  std::size_t strip() const { return word / 4; }
  Part part() const { return static_cast<Part>(word % 4); }
};

/// A convex part of a strip's penumbra in the light's image, on one side of the silhouette.
struct StripSplat {
  std::array<SnappedPoint, 4> corners;
  std::uint32_t count = 0;
  StripName name;
  bool inside = false;
};

/// The quads of every strip, one on either side, and the fans that close the gap between two strips
/// on the outer side of the turn between them.
/// Source: soft shadow occlusion camera, 3.2.1; the fans are ours.
std::vector<StripSplat> strip_splats(std::span<const PenumbraStrip> strips);

}  // namespace wedgesim::functional
