#pragma once

#include <cstdint>
#include <initializer_list>
#include <set>
#include <utility>

#include "traces/trace.h"

namespace wedgesim::model::test {

namespace fb = traces::fb;
using Pixel = std::pair<int, int>;  // x, y
using Pixels = std::set<Pixel>;

inline Pixels join(const Pixels& a, const Pixels& b) {
  Pixels all = a;
  all.insert(b.begin(), b.end());
  return all;
}
Pixels without(const Pixels& a, const Pixels& b);
Pixels meet(const Pixels& a, const Pixels& b);

/// What a tile's pixels and their depths are in.
struct NaiveBox {
  double x[2], y[2];
  double z_min = 1.0, z_max = 0.0;
};

/// What a trace says of pixels and tiles by the definitions alone: the pixels that polygons cover,
/// which of them are inside, and which tiles each test culls or accepts.
class NaiveFrame {
 public:
  /// \param tile  side, pixels
  /// \param fail  z-fail
  NaiveFrame(const traces::TraceView& trace, int tile, bool fail);

  std::uint64_t tiles() const;
  Pixels tile_pixels(const Pixel& tile) const;
  NaiveBox box(const Pixel& tile) const;
  std::size_t index(const Pixel& p) const;
  double z_of(const Pixel& p) const;

  /// Twice the signed area, units of the snapped grid.
  template <typename Polygon>
  std::int64_t area(const Polygon& polygon) const;
  template <typename Polygon>
  Pixels covered(const Polygon& polygon) const;
  bool in_plane(std::uint32_t reference, double x, double y, double z) const;
  bool is_inside(const fb::Wedge& wedge, const Pixel& p) const;
  /// Whether a pixel that an umbra polygon covers is counted: in z-pass where it passes, in z-fail
  /// where it fails.
  bool hit(const fb::UmbraPolygon& u, const Pixel& p) const;
  bool inner(const fb::UmbraPolygon& u, const Pixel& p, bool polygon_covers) const;

  bool face_culled_zmax(const fb::Face& face, const NaiveBox& b) const;
  bool zrange_culled(const fb::Wedge& wedge, const NaiveBox& b) const;
  bool planes_culled(const fb::Wedge& wedge, const NaiveBox& b) const;
  bool sat_culled(const fb::Wedge& wedge, const NaiveBox& b) const;
  bool box_inside(const fb::Wedge& wedge, const NaiveBox& b) const;
  bool umbra_culled(const fb::UmbraPolygon& u, const NaiveBox& b) const;
  bool umbra_accepted(const fb::UmbraPolygon& u, const NaiveBox& b) const;

 private:
  template <typename Polygon>
  const fb::ScreenVertex& vertex(const Polygon& polygon, std::uint32_t i) const {
    return trace_.vertices[trace_.indices[polygon.first_index() + i % polygon.index_count()]];
  }
  double inward_c(std::uint32_t reference) const;
  // How many of the box's corners, at the depths given, are inside.
  int corners_inside(std::uint32_t reference, const NaiveBox& box,
                     std::initializer_list<double> depths) const;
  int corners_hit(const fb::UmbraPolygon& u, const NaiveBox& b, double z) const;
  bool plane_usable(const fb::UmbraPolygon& u) const;

  const traces::TraceView& trace_;
  int width_, height_, tile_;
  bool fail_;
};

template <typename Polygon>
std::int64_t NaiveFrame::area(const Polygon& polygon) const {
  std::int64_t sum = 0;
  for (std::uint32_t i = 0; i < polygon.index_count(); ++i) {
    const auto& p = vertex(polygon, i);
    const auto& q = vertex(polygon, i + 1);
    sum += std::int64_t{p.x()} * q.y() - std::int64_t{p.y()} * q.x();
  }
  return sum;
}
// Edge functions at every pixel centre of the frame.
template <typename Polygon>
Pixels NaiveFrame::covered(const Polygon& polygon) const {
  Pixels pixels;
  const std::int64_t sign = area(polygon) > 0 ? 1 : -1;
  if (area(polygon) == 0) return pixels;
  for (int y = 0; y < height_; ++y) {
    for (int x = 0; x < width_; ++x) {
      bool in = true;
      for (std::uint32_t i = 0; i < polygon.index_count() && in; ++i) {
        const auto& p = vertex(polygon, i);
        const auto& q = vertex(polygon, i + 1);
        const std::int64_t dx = sign * (std::int64_t{q.x()} - p.x());
        const std::int64_t dy = sign * (std::int64_t{q.y()} - p.y());
        const std::int64_t e = dx * (256 * y + 128 - p.y()) - dy * (256 * x + 128 - p.x());
        const bool top_left = dy < 0 || (dy == 0 && dx > 0);
        in = e > 0 || (e == 0 && top_left);
      }
      if (in) pixels.insert({x, y});
    }
  }
  return pixels;
}

}  // namespace wedgesim::model::test
