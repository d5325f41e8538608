#pragma once

#include <array>
#include <cstdint>
#include <glm/vec2.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "functional/light/split_word.h"

namespace wedgesim::functional {

/// The angle of a direction in the plane, from a cube map of six faces, 128 × 128 texels of 16 bits
/// each: the middle rows of four faces are read, the nearest texel, as interpolation would mix −π
/// and π. Off by at most 1/128 radian.
/// Source: Paper IV, 4.2.1 and 6 (contents and size). Differs: its filter is not told.
class AngleMap {
 public:
  AngleMap();
  /// \return [−π, π]; of any direction but (0, 0)
  float angle(const glm::vec2& direction) const;
  static constexpr int kSide = 128;
  static constexpr std::size_t kBytes = 6 * kSide * kSide * 2;
  /// The rows of the faces +x, −x, +y, −y: angles as the words round them.
  const float* texels() const { return texels_.data(); }

 private:
  std::array<float, 4 * kSide> texels_{};
};

/// What a chord of a light hides, from two angles: the part of the light between the rays to the
/// chord's ends, from a table of 256 × 256, less the triangle of the centre and the chord.
/// Source: Paper IV, 4.2 (the arithmetic, in single precision) and 6 (sizes and word widths).
class SectorTable {
 public:
  /// A disc of radius 1: words of 16 bits, π/2 the largest.
  static SectorTable disc();
  /// The square [−1, 1]²: words of 8 bits, half the square the largest.
  static SectorTable square();

  /// The fraction of the light that a chord hides.
  /// \param p, q  within the light, in either order
  /// \return [0, 1/2]
  float coverage(const glm::vec2& p, const glm::vec2& q) const;
  /// Of this table alone, at the word widths of the paper.
  std::size_t bytes() const { return table_.size() * word_bytes_; }

  // What coverage() reads, for many chords at once (sector_simd.h).
  static constexpr int kSide = 256;
  const AngleMap& angles() const { return angles_; }
  /// (angle of q, angle of p) the areas, kSide × kSide from −π to π.
  const float* areas() const { return table_.data(); }
  float light_area() const { return area_; }

 private:
  SectorTable(double area, std::uint32_t largest_word, double (*sector)(double, double));
  float area_between(float angle_p, float angle_q) const;

  AngleMap angles_;
  std::vector<float> table_;  // (angle of q, angle of p) areas as the words round them
  float area_;                // of the light
  std::size_t word_bytes_;
};

/// What an edge hides of a spherical light, as the shader computes it: clipped by the cone from the
/// point through the disc of the sphere's radius across the axis, in single precision.
/// \param point, begin, end  light space (radii)
/// \return [0, 1/2]
/// Source: Paper IV, 4.2.1. The true tangent cone is wider: see sphere_coverage.
float shader_sphere_coverage(const SectorTable& disc, const glm::dvec3& point,
                             const glm::dvec3& begin, const glm::dvec3& end);

/// What an edge hides of a rectangular light, as the shader computes it.
/// \param point, begin, end  light space; begin and end in front of the light (third > 0)
/// \return [0, 1/2]
/// Source: Paper IV, 4.2.2.
float shader_rectangle_coverage(const SectorTable& square, const glm::dvec3& point,
                                const glm::dvec3& begin, const glm::dvec3& end);

/// A coverage as the word to blend: the 1D texture of 1024 entries that splits it.
/// \param coverage  [0, 1/2], the range of the entries
/// Source: Paper IV, 6. Differs: the range of the entries is not told.
SplitWord split_coverage(float coverage);
/// Its entries, the four components as they lie in memory.
std::span<const std::int32_t> split_words();

}  // namespace wedgesim::functional
