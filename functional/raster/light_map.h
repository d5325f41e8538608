#pragma once

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "functional/raster/window.h"

namespace wedgesim::functional {

/// A square map seen from a light's centre is a Window whose eye is that centre: x and y in texels,
/// centres at +0.5, w the distance along its axis (window.h; clip.h and spans.h work on it).
using LightView = Window;

/// The narrowest view from a point along an axis that shows the points given, half a texel inside
/// its borders; x and y are scaled each by itself. Points not in front of `near` are left out.
/// \param axis  any length; \param near  world units along the axis, above 0
/// \return a view of width 0 if no point is in front of `near`
LightView make_light_view(const glm::dvec3& centre, const glm::dvec3& axis, double near,
                          std::span<const glm::dvec3> points, int resolution);

/// Where a world point is in a map: texels, and the distance w along the axis.
struct MapPlace {
  double x = 0.0;
  double y = 0.0;
  double w = 0.0;
};
MapPlace place_in(const LightView& view, const glm::dvec3& p);

/// The rays from the light's centre through a map.
class MapRays {
 public:
  explicit MapRays(const LightView& view);
  /// The world vector along the ray at (x, y), as long as one unit along the axis makes it: the
  /// point at distance w along the axis is centre + w · at(x, y).
  glm::dvec3 at(double x, double y) const { return origin_ + x * dx_ + y * dy_; }
  const glm::dvec3& dx() const { return dx_; }  // to the next texel's
  const glm::dvec3& dy() const { return dy_; }
  /// The distance from the centre of a point with w = 1.
  double length(double x, double y) const {
    const glm::dvec3 ray = at(x, y);
    return std::sqrt(ray.x * ray.x + ray.y * ray.y + ray.z * ray.z);
  }

 private:
  glm::dvec3 origin_, dx_, dy_;
};

/// The function a·x + b·y + c of a place in a map.
struct TexelPlane {
  double a = 0.0, b = 0.0, c = 0.0;
  double at(double x, double y) const { return a * x + b * y + c; }
};

/// Bands of a map are drawn by blocks of texels (map_blocks_simd.h).
inline constexpr int kBlockEdge = 4;
inline constexpr int kBlock = kBlockEdge * kBlockEdge;  // texels

/// A triangle of the world, or a part of one that the near plane or the guard band cut, as it is
/// drawn in a map.
struct MapTriangle {
  struct Corner {
    std::int32_t x = 0, y = 0;  // 1/256 texels
  };
  std::array<Corner, 3> corners;
  bool faces_light = false;  // wound counter-clockwise as the light sees it
  std::uint8_t tag = 0;      // its maker's
  TexelPlane inverse_w;      // 1/w of its points
  double inverse_low = 0.0;  // of what is drawn
  double inverse_high = 0.0;
  TexelPlane value_over_w, other_over_w;  // of functions that are linear on it in the world
};

/// Triangles clipped to a map's near plane and snapped (clip.h), ready to be drawn band by band:
/// bands of rows do not depend on each other, so each can be drawn by a thread of its own.
class MapTriangles {
 public:
  using Corners = std::array<glm::dvec3, 3>;
  static constexpr int kBandRows = 8;

  struct Input {
    Corners corners;
    std::array<double, 3> value{1.0, 1.0, 1.0}, other{1.0, 1.0, 1.0};  // at the corners
    std::uint8_t tag = 0;
    bool one_sided = false;  // left out unless it faces the light
  };

  MapTriangles() = default;
  MapTriangles(MapTriangles&&) = default;
  MapTriangles& operator=(MapTriangles&&) = default;
  /// \param input  of a triangle, by its number below `count`; called from several threads
  MapTriangles(const LightView& view, std::size_t count,
               const std::function<Input(std::size_t)>& input);

  /// Bands of a map with `size` rows.
  static int bands(int size) { return (size + kBandRows - 1) / kBandRows; }
  /// What may cover texels of a band, in the order of the triangles.
  std::span<const MapTriangle* const> band(int band) const {
    const auto b = static_cast<std::size_t>(band);
    if (begins_.empty()) return {};
    return std::span(in_bands_).subspan(begins_[b], begins_[b + 1] - begins_[b]);
  }

 private:
  std::vector<std::vector<MapTriangle>> triangles_;
  std::vector<const MapTriangle*> in_bands_;  // one band after the other
  std::vector<std::size_t> begins_;           // of each band, then the number of all
};

/// How the distance from the light's centre is found inside a triangle.
enum class Distances {
  exact,        // of the point that the texel's ray meets
  interpolated  // linearly on the triangle between its corners' distances, as hardware does
};

enum class Keep { nearest, farthest };

/// A map of the distances of triangles from the light's centre, (resolution, resolution), row by
/// row; where nothing is, `empty`. Of several triangles the nearest or the farthest is kept.
std::vector<float> draw_distances(const LightView& view,
                                  std::span<const std::array<glm::dvec3, 3>> triangles, Keep keep,
                                  float empty, Distances distances = Distances::exact);

}  // namespace wedgesim::functional
