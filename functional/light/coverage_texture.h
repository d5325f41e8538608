#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <memory>
#include <vector>

#include "functional/light/coverage.h"
#include "functional/light/emission.h"

namespace wedgesim::functional {

enum class CoverageWords { float32, bits8 };

/// A table of what every chord of a rectangular light hides: f(x1, y1, x2, y2) for n × n ends each,
/// evenly from border to border.
/// A chord near the light's centre may have entries that pass the centre on its other side. What
/// the chord hides is then not what the entry does, but the entry continued past the centre: the
/// rest of the light, or less than nothing if it passes beside the chord. Without that, the corners
/// of shadows, and textured lights along the hard shadow's edge, would be wrong by parts of the
/// light. Source: Paper III, 3.3 (n = 32, 8 bits, 3 MB for three colours). Differs: the outermost
/// entries lie on the light's border, where most clipped ends are; the continuation.
class CoverageTexture {
 public:
  static constexpr int kLeastSide = 8;
  static constexpr int kMostSide = 64;

  /// \param side  n, even: no entry lies on the light's centre, where f has no value
  CoverageTexture(const Emission& emission, int side, CoverageWords words);

  /// What a chord hides, by the nearest entry or by linear interpolation between 16.
  /// \param p, q  light space, inside the square [−1, 1]², in either order
  /// \return      fractions of the power of each channel
  std::array<float, 3> nearest(const glm::dvec2& p, const glm::dvec2& q) const;
  std::array<float, 3> quadlinear(const glm::dvec2& p, const glm::dvec2& q) const;

  int channels() const { return channels_; }
  std::size_t bytes() const { return floats_.size() * sizeof(float) + bytes_.size(); }

 private:
  void fill(const Emission& emission);
  void put(std::size_t from, std::size_t to, const Emission::Colour& part);
  float value(std::size_t i) const;
  void add(const Chord& chord, std::size_t from, std::size_t to, float weight,
           std::array<float, 3>& sum) const;

  int side_;
  int channels_;
  std::vector<glm::dvec2> positions_;  // of an end's entries, row-major n × n
  std::vector<float> floats_;  // (from, to, channels), from and to row-major n × n; or empty:
  std::vector<std::uint8_t> bytes_;  // the same, 255 is the whole light
};

/// The texture of a light, made once: a light, or each picture of a short sequence, keeps its own
/// as long as they fit (512 MB in all, the last made stay).
/// \param texture  of the light; null: even
std::shared_ptr<const CoverageTexture> coverage_texture(const std::shared_ptr<const Image>& texture,
                                                        int side, CoverageWords words);

}  // namespace wedgesim::functional
