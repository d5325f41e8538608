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
enum class TextureFilter { nearest, quadlinear };

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
  /// At the words' widths; in memory three bytes take four.
  std::size_t bytes() const;

  // What nearest() and quadlinear() read, for many chords at once (texture_simd.h): entries are
  // from · n² + to, from and to row · n + column.
  int side() const { return side_; }
  /// (entry, channel); null if words of 8 bits.
  const float* floats() const { return floats_.empty() ? nullptr : floats_.data(); }
  /// Bytes from the lowest of a word on, 255 is the whole light: of one channel four entries a
  /// word, of three one. Null if floats.
  const std::int32_t* bytes_in_words() const { return words_.empty() ? nullptr : words_.data(); }

 private:
  // Calls put(entry, part) for all entries, in parallel.
  template <typename Put>
  void fill(const Emission& emission, const Put& put) const;
  void fill_floats(const Emission& emission);
  void fill_words(const Emission& emission);
  float value(std::size_t entry, std::size_t channel) const;
  void add(const Chord& chord, std::size_t from, std::size_t to, float weight,
           std::array<float, 3>& sum) const;

  int side_;
  int channels_;
  std::vector<glm::dvec2> places_;  // of an end's entries, in half spacings: whole numbers
  std::vector<float> floats_;       // or empty:
  std::vector<std::int32_t> words_;
};

/// The texture of a light, made once: a light, or each picture of a short sequence, keeps its own
/// as long as they fit (512 MB in all, the last made stay).
/// \param texture  of the light; null: even
std::shared_ptr<const CoverageTexture> coverage_texture(const std::shared_ptr<const Image>& texture,
                                                        int side, CoverageWords words);

}  // namespace wedgesim::functional
