#include "tests/model/count/naive_frame.h"

#include <algorithm>
#include <iterator>

#include "traces/depth.h"

namespace wedgesim::model::test {

Pixels without(const Pixels& a, const Pixels& b) {
  Pixels rest;
  std::set_difference(a.begin(), a.end(), b.begin(), b.end(), std::inserter(rest, rest.end()));
  return rest;
}

Pixels meet(const Pixels& a, const Pixels& b) {
  Pixels both;
  std::set_intersection(a.begin(), a.end(), b.begin(), b.end(), std::inserter(both, both.end()));
  return both;
}

NaiveFrame::NaiveFrame(const traces::TraceView& trace, int tile, bool fail)
    : trace_(trace),
      width_(static_cast<int>(trace.header.width)),
      height_(static_cast<int>(trace.header.height)),
      tile_(tile),
      fail_(fail) {}

std::uint64_t NaiveFrame::tiles() const {
  return static_cast<std::uint64_t>((width_ + tile_ - 1) / tile_) *
         static_cast<std::uint64_t>((height_ + tile_ - 1) / tile_);
}

double NaiveFrame::z_of(const Pixel& p) const {
  return traces::decode_depth(trace_.header.depth_format, trace_.depth[index(p)]);
}

std::size_t NaiveFrame::index(const Pixel& p) const {
  return static_cast<std::size_t>(p.second * width_ + p.first);
}

bool NaiveFrame::in_plane(std::uint32_t reference, double x, double y, double z) const {
  const fb::Plane& p = trace_.planes[reference / 2];
  const bool s = ((p.a() * x + p.b() * y) + p.c() * z) + p.d() >= 0.0;
  return reference % 2 == 0 ? s : !s;
}

double NaiveFrame::inward_c(std::uint32_t reference) const {
  const double c = trace_.planes[reference / 2].c();
  return reference % 2 == 0 ? c : -c;
}

int NaiveFrame::corners_inside(std::uint32_t reference, const NaiveBox& box,
                               std::initializer_list<double> depths) const {
  int inside = 0;
  for (double z : depths) {
    for (double x : box.x) {
      for (double y : box.y) inside += in_plane(reference, x, y, z) ? 1 : 0;
    }
  }
  return inside;
}

NaiveBox NaiveFrame::box(const Pixel& tile) const {
  NaiveBox b{{static_cast<double>(tile.first * tile_),
              static_cast<double>(std::min((tile.first + 1) * tile_, width_))},
             {static_cast<double>(tile.second * tile_),
              static_cast<double>(std::min((tile.second + 1) * tile_, height_))}};
  for (const Pixel& p : tile_pixels(tile)) {
    b.z_min = std::min(b.z_min, z_of(p));
    b.z_max = std::max(b.z_max, z_of(p));
  }
  return b;
}

Pixels NaiveFrame::tile_pixels(const Pixel& tile) const {
  Pixels pixels;
  for (int y = tile.second * tile_; y < std::min((tile.second + 1) * tile_, height_); ++y) {
    for (int x = tile.first * tile_; x < std::min((tile.first + 1) * tile_, width_); ++x) {
      pixels.insert({x, y});
    }
  }
  return pixels;
}

bool NaiveFrame::face_culled_zmax(const fb::Face& face, const NaiveBox& b) const {
  if (!fail_) {
    return face.z_min() > b.z_max ||
           (inward_c(face.plane()) >= 0.0 && corners_inside(face.plane(), b, {b.z_max}) == 0);
  }
  return face.z_max() < b.z_min ||
         (inward_c(face.plane()) <= 0.0 && corners_inside(face.plane(), b, {b.z_min}) == 0);
}

bool NaiveFrame::zrange_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
  return wedge.z_min() > b.z_max || wedge.z_max() < b.z_min;
}

bool NaiveFrame::planes_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    if (corners_inside((*wedge.planes())[i], b, {b.z_min, b.z_max}) == 0) return true;
  }
  return false;
}

bool NaiveFrame::sat_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
  int beyond[6] = {};
  int vertices = 0;
  for (std::uint32_t f = 0; f < wedge.face_count(); ++f) {
    const fb::Face& face = trace_.faces[wedge.first_face() + f];
    for (std::uint32_t i = 0; i < face.index_count(); ++i, ++vertices) {
      const auto& v = vertex(face, i);
      beyond[0] += v.x() / 256.0 > b.x[1] + 1.0 / 128 ? 1 : 0;
      beyond[1] += v.x() / 256.0 < b.x[0] - 1.0 / 128 ? 1 : 0;
      beyond[2] += v.y() / 256.0 > b.y[1] + 1.0 / 128 ? 1 : 0;
      beyond[3] += v.y() / 256.0 < b.y[0] - 1.0 / 128 ? 1 : 0;
      beyond[4] += v.z() > b.z_max + 1e-9 ? 1 : 0;
      beyond[5] += v.z() < b.z_min - 1e-9 ? 1 : 0;
    }
  }
  if (wedge.z_min() <= 0.0) {  // cut by the near plane
    beyond[4] += 0.0 > b.z_max + 1e-9 ? 1 : 0;
    beyond[5] += 0.0 < b.z_min - 1e-9 ? 1 : 0;
    for (int i = 0; i < 4; ++i) ++beyond[i];
    ++vertices;
  }
  return std::any_of(beyond, beyond + 6, [vertices](int n) { return n == vertices; });
}

bool NaiveFrame::box_inside(const fb::Wedge& wedge, const NaiveBox& b) const {
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    if (corners_inside((*wedge.planes())[i], b, {b.z_min, b.z_max}) != 8) return false;
  }
  return b.z_min >= wedge.z_min() && b.z_max <= wedge.z_max();
}

bool NaiveFrame::hit(const fb::UmbraPolygon& u, const Pixel& p) const {
  if (u.role() == fb::UmbraRole_cap) return true;
  bool passes = inner(u, p, true);
  if (area(u) > 0) passes = !passes;
  return fail_ ? !passes : passes;
}

bool NaiveFrame::inner(const fb::UmbraPolygon& u, const Pixel& p, bool polygon_covers) const {
  const double z = z_of(p);
  const bool eye = area(u) < 0;
  if (polygon_covers && z < u.z_min()) return !eye;
  if (polygon_covers && z > u.z_max()) return eye;
  return in_plane(u.plane(), p.first + 0.5, p.second + 0.5, z);
}

int NaiveFrame::corners_hit(const fb::UmbraPolygon& u, const NaiveBox& b, double z) const {
  const int in = corners_inside(u.plane(), b, {z});
  const bool hits_inner = (area(u) < 0) != fail_;
  return hits_inner ? in : 4 - in;
}

bool NaiveFrame::plane_usable(const fb::UmbraPolygon& u) const {
  // The side that is hit must be the far one in z-pass, the near one in z-fail.
  const bool hits_inner = (area(u) < 0) != fail_;
  const double c = hits_inner ? inward_c(u.plane()) : -inward_c(u.plane());
  return fail_ ? c <= 0.0 : c >= 0.0;
}

bool NaiveFrame::umbra_culled(const fb::UmbraPolygon& u, const NaiveBox& b) const {
  if (!fail_) {
    return u.z_min() > b.z_max ||
           (plane_usable(u) && b.z_max <= u.z_max() && corners_hit(u, b, b.z_max) == 0);
  }
  return u.z_max() < b.z_min ||
         (plane_usable(u) && b.z_min >= u.z_min() && corners_hit(u, b, b.z_min) == 0);
}

bool NaiveFrame::umbra_accepted(const fb::UmbraPolygon& u, const NaiveBox& b) const {
  if (!fail_) {
    return u.z_max() < b.z_min ||
           (plane_usable(u) && b.z_min >= u.z_min() && corners_hit(u, b, b.z_min) == 4);
  }
  return u.z_min() > b.z_max ||
         (plane_usable(u) && b.z_max <= u.z_max() && corners_hit(u, b, b.z_max) == 4);
}

bool NaiveFrame::is_inside(const fb::Wedge& wedge, const Pixel& p) const {
  const double z = z_of(p);
  for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
    if (!in_plane((*wedge.planes())[i], p.first + 0.5, p.second + 0.5, z)) return false;
  }
  return z >= wedge.z_min() && z <= wedge.z_max();
}

}  // namespace wedgesim::model::test
