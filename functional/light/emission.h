#pragma once

#include <array>
#include <glm/vec2.hpp>
#include <vector>

#include "base/image.h"

namespace wedgesim::functional {

/// How the power of a rectangular light is spread over it: evenly, or as a texture says. Sums over
/// parts of the light are exact integrals of the piecewise constant texture along the part's
/// outline (Green's theorem), not sums of whole texels.
class Emission {
 public:
  /// Fractions of the power of each colour: red, green and blue, or one for all of them.
  using Colour = std::array<double, 3>;

  /// Evenly: one channel.
  Emission();
  /// \param shares  (height, width, 3) as emission_shares() gives them; columns run along light
  ///                space's x, rows along y
  explicit Emission(const Image& shares);

  int channels() const { return channels_; }

  /// The fraction beyond a chord: between the rays from the light's centre through p and q, on the
  /// far side of the segment pq. A chord through the centre takes the side to its right.
  /// \param p, q  light space, inside the square [−1, 1]², in either order
  /// \return      of each channel, [0, 1]; the others 0
  /// Source: Paper III, 3.2.2 and 3.3: what the shadow quad of an edge that projects to pq hides.
  Colour beyond(const glm::dvec2& p, const glm::dvec2& q) const;

  /// The same in parts, for tables of many chords: beyond = round(q) − round(p) − along(p, q), plus
  /// everything if the arc from p counter-clockwise to q passes the corner
  /// (1, −1), where `round` begins.
  Colour along(const glm::dvec2& from, const glm::dvec2& to) const;
  Colour round(const glm::dvec2& p) const;
  static bool passes_start(const glm::dvec2& p, const glm::dvec2& q);

  // What beyond() reads, of colours in single precision, for many chords at once (emission_simd.h).
  int width() const { return width_; }
  int height() const { return height_; }
  /// (height, width, 6): the power of the row's texels to the left, then the texel's own.
  const float* texels() const { return texels_.data(); }
  /// (height + 1, 3): of all rows before one.
  const float* below() const { return below_in_float_.data(); }

 private:
  glm::dvec2 texels(const glm::dvec2& p) const;
  void sum_rows();
  void round_to_float();
  void add_along(const glm::dvec2& from, const glm::dvec2& to, double sign, Colour& sum) const;

  int width_ = 1;
  int height_ = 1;
  int channels_ = 1;
  std::vector<double> share_;   // (height, width, channels), sums to 1
  std::vector<double> before_;  // (height, width, channels) of the row's texels to the left
  std::vector<Colour> below_;   // (height + 1) of all rows before one
  std::vector<float> texels_, below_in_float_;  // of three channels
};

}  // namespace wedgesim::functional
