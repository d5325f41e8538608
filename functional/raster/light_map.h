#pragma once

#include <tbb/parallel_for.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/mat3x3.hpp>
#include <glm/vec3.hpp>
#include <span>
#include <vector>

#include "functional/raster/spans.h"
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

/// What of a triangle is in a map.
struct MapTriangle {
  std::uint32_t index = 0;   // of the triangle in the list it came from
  bool faces_light = false;  // wound counter-clockwise as the light sees it
  double w_low = 0.0;        // of its clipped outline
  double w_high = 0.0;
  TexelPlane inverse_w;  // 1/w of its points
  /// f/w of a function f that is linear on the triangle in the world, by its values at the corners.
  TexelPlane over_w(const std::array<double, 3>& values) const;
  /// w at a place, kept within the outline's.
  double w(double x, double y) const {
    const double inverse = inverse_w.at(x, y);
    return inverse * w_high <= 1.0 ? w_high : std::max(w_low, 1.0 / inverse);
  }

  glm::dmat3 inverse_corners{0.0};  // of the corners' (x·w, y·w, w), each a column
  std::array<SnappedPoint, 10> outline{};
  std::uint32_t corners = 0;  // of the outline
};

/// Triangles clipped to a map's near plane and snapped (clip.h), ready to be drawn.
class MapTriangles {
 public:
  MapTriangles(const LightView& view, std::span<const std::array<glm::dvec3, 3>> triangles);

  /// Calls row(triangle, y, x_begin, x_end) for every row of texels whose centres a triangle covers
  /// (spans.h). Rows of one band of the map come from one thread in the order of the triangles,
  /// bands run in parallel: what a row writes to its texels alone needs no lock, and is the same
  /// whatever the number of threads.
  template <typename Row>
  void for_each_row(Row&& row) const;

  /// The parts that the triangles are drawn as, by a number of their own.
  const MapTriangle& operator[](std::uint32_t id) const { return triangles_[id]; }
  /// \param triangle  one that for_each_row gave
  std::uint32_t id(const MapTriangle& triangle) const {
    return static_cast<std::uint32_t>(&triangle - triangles_.data());
  }

  /// Rows and columns that may be covered: begin and past the end.
  struct Box {
    int x_begin = 0, x_end = 0, y_begin = 0, y_end = 0;
  };
  const Box& box() const { return box_; }

 private:
  static constexpr int kBandRows = 16;
  int size_ = 0;
  Box box_;
  std::vector<MapTriangle> triangles_;
  std::vector<std::uint32_t> bands_;      // of each band its triangles, one band after the other
  std::vector<std::size_t> bands_begin_;  // of each band, then the number of all
};

template <typename Row>
void MapTriangles::for_each_row(Row&& row) const {
  const int bands = static_cast<int>(bands_begin_.size()) - 1;
  tbb::parallel_for(0, std::max(0, bands), [&](int band) {
    const auto b = static_cast<std::size_t>(band);
    const int y_begin = band * kBandRows;
    const int y_end = std::min(size_, y_begin + kBandRows);
    for (std::size_t i = bands_begin_[b]; i < bands_begin_[b + 1]; ++i) {
      const MapTriangle& triangle = triangles_[bands_[i]];
      for_each_span({triangle.outline.data(), triangle.corners}, size_, y_begin, y_end,
                    [&](int y, int x_begin, int x_end) { row(triangle, y, x_begin, x_end); });
    }
  });
}

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
