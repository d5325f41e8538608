#pragma once

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace wedgesim::functional {

/// A word of 12 bits over the four components of an 8-bit frame buffer: 3 bits in each, and 5 above
/// them that carries go to when words are blended. Sums are right up to 36 words (255 / 7), of
/// which the paper reckons with 32; then a component stays at 255 and the sum is too small.
/// Source: Paper IV, 4.3.
struct SplitWord {
  static constexpr int kBits = 12;
  static constexpr int kWhole = (1 << kBits) - 1;  // of the light
  std::array<std::uint8_t, 4> components{};        // the highest bits first

  /// \param value  0 to kWhole
  static constexpr SplitWord pack(int value) {
    SplitWord word;
    for (std::size_t i = 0; i < 4; ++i) {
      word.components[i] = static_cast<std::uint8_t>(value >> (9 - 3 * i) & 7);
    }
    return word;
  }
  /// Additive blending: each component by itself, up to 255.
  constexpr void add(const SplitWord& other) {
    for (std::size_t i = 0; i < 4; ++i) {
      components[i] = static_cast<std::uint8_t>(std::min(255, components[i] + other.components[i]));
    }
  }
  /// The sum of what was added.
  constexpr int unpack() const {
    int sum = 0;
    for (const std::uint8_t component : components) sum = 8 * sum + component;
    return sum;
  }
};

/// A contribution in one 8-bit component: 6 bits of it, 2 for what overlaps, up to 255.
/// Source: Paper III, 4.2.
struct ShortWord {
  static constexpr int kWhole = 63;  // of the light
  std::uint8_t component = 0;

  /// \param coverage  [0, 1]
  static ShortWord of(float coverage) {
    return {static_cast<std::uint8_t>(coverage * static_cast<float>(kWhole) + 0.5F)};
  }
  constexpr void add(ShortWord other) {
    component = static_cast<std::uint8_t>(std::min(255, component + other.component));
  }
};

}  // namespace wedgesim::functional
