#include "tests/model/count/naive_counter.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "model/count/contribution.h"
#include "traces/depth.h"
#include "traces/record.h"

namespace wedgesim::model::test {
namespace {

namespace fb = traces::fb;
using traces::kNone;
using traces::TraceView;
using Pixel = std::pair<int, int>;  // x, y
using Pixels = std::set<Pixel>;

Pixels join(const Pixels& a, const Pixels& b) {
  Pixels all = a;
  all.insert(b.begin(), b.end());
  return all;
}
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

struct NaiveBox {
  double x[2], y[2];
  double z_min = 1.0, z_max = 0.0;
};

class Naive {
 public:
  Naive(const TraceView& trace, const CountConfig& config, bool fail)
      : trace_(trace),
        config_(config),
        fail_(fail),
        width_(static_cast<int>(trace.header.width)),
        height_(static_cast<int>(trace.header.height)),
        tile_(static_cast<int>(config.tile)) {
    result_.li.assign(trace.depth.size(), std::int64_t{1} << 40);
    result_.z_reads.assign(trace.depth.size(), 0);
    result_.li_writes.assign(trace.depth.size(), 0);
    stencil_.assign(trace.depth.size(), 0);
    contributions_.assign(trace.depth.size(), 0);
    for (const char* name :
         {"z_reads", "z_reads_whole_tile", "li_writes", "stencil_writes", "tile_visits",
          "tile_reads", "visits_culled_zmax", "visits_culled_zrange", "visits_culled_planes",
          "visits_culled_sat", "umbra_visits_culled", "umbra_visits_accepted", "tiles_inside",
          "pixels_covered", "pixels_inside", "wedge_bytes", "degenerate_wedges"}) {
      count(name) = 0;
    }
  }

  NaiveCount run() {
    for (std::uint32_t w = 0; w < trace_.wedges.size(); ++w) wedge(w);
    for (std::uint32_t u = 0; u < trace_.umbra_polygons.size(); ++u) {
      if (trace_.umbra_polygons[u].wedge() == kNone) primitive(kNone, u);
    }
    finish();
    return std::move(result_);
  }

 private:
  bool single() const { return config_.mode == Mode::single_pass; }
  std::uint64_t& count(const char* name) { return result_.counters[name]; }

  template <typename Polygon>
  std::int64_t area(const Polygon& polygon) const {
    std::int64_t sum = 0;
    for (std::uint32_t i = 0; i < polygon.index_count(); ++i) {
      const auto& p = vertex(polygon, i);
      const auto& q = vertex(polygon, i + 1);
      sum += std::int64_t{p.x()} * q.y() - std::int64_t{p.y()} * q.x();
    }
    return sum;
  }
  template <typename Polygon>
  const fb::ScreenVertex& vertex(const Polygon& polygon, std::uint32_t i) const {
    return trace_.vertices[trace_.indices[polygon.first_index() + i % polygon.index_count()]];
  }

  // Edge functions at every pixel centre of the frame.
  template <typename Polygon>
  Pixels covered(const Polygon& polygon) const {
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

  double z_of(const Pixel& p) const {
    return traces::decode_depth(trace_.header.depth_format, trace_.depth[index(p)]);
  }
  std::size_t index(const Pixel& p) const {
    return static_cast<std::size_t>(p.second * width_ + p.first);
  }

  bool in_plane(std::uint32_t reference, double x, double y, double z) const {
    const fb::Plane& p = trace_.planes[reference / 2];
    const bool s = ((p.a() * x + p.b() * y) + p.c() * z) + p.d() >= 0.0;
    return reference % 2 == 0 ? s : !s;
  }
  double inward_c(std::uint32_t reference) const {
    const double c = trace_.planes[reference / 2].c();
    return reference % 2 == 0 ? c : -c;
  }
  // How many of the box's corners, at the depths given, are inside.
  int corners_inside(std::uint32_t reference, const NaiveBox& box,
                     std::initializer_list<double> depths) const {
    int inside = 0;
    for (double z : depths) {
      for (double x : box.x) {
        for (double y : box.y) inside += in_plane(reference, x, y, z) ? 1 : 0;
      }
    }
    return inside;
  }

  NaiveBox box(const Pixel& tile) const {
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
  Pixels tile_pixels(const Pixel& tile) const {
    Pixels pixels;
    for (int y = tile.second * tile_; y < std::min((tile.second + 1) * tile_, height_); ++y) {
      for (int x = tile.first * tile_; x < std::min((tile.first + 1) * tile_, width_); ++x) {
        pixels.insert({x, y});
      }
    }
    return pixels;
  }

  bool face_culled_zmax(const fb::Face& face, const NaiveBox& b) const {
    if (!fail_) {
      return face.z_min() > b.z_max ||
             (inward_c(face.plane()) >= 0.0 && corners_inside(face.plane(), b, {b.z_max}) == 0);
    }
    return face.z_max() < b.z_min ||
           (inward_c(face.plane()) <= 0.0 && corners_inside(face.plane(), b, {b.z_min}) == 0);
  }
  bool zrange_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
    return wedge.z_min() > b.z_max || wedge.z_max() < b.z_min;
  }
  bool planes_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
    for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
      if (corners_inside((*wedge.planes())[i], b, {b.z_min, b.z_max}) == 0) return true;
    }
    return false;
  }
  bool sat_culled(const fb::Wedge& wedge, const NaiveBox& b) const {
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
  bool box_inside(const fb::Wedge& wedge, const NaiveBox& b) const {
    for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
      if (corners_inside((*wedge.planes())[i], b, {b.z_min, b.z_max}) != 8) return false;
    }
    return b.z_min >= wedge.z_min() && b.z_max <= wedge.z_max();
  }

  // z-pass: the polygon passes; z-fail: it fails.
  bool hit(const fb::UmbraPolygon& u, const Pixel& p) const {
    if (u.role() == fb::UmbraRole_cap) return true;
    bool passes = inner(u, p, true);
    if (area(u) > 0) passes = !passes;
    return fail_ ? !passes : passes;
  }
  bool inner(const fb::UmbraPolygon& u, const Pixel& p, bool polygon_covers) const {
    const double z = z_of(p);
    const bool eye = area(u) < 0;
    if (polygon_covers && z < u.z_min()) return !eye;
    if (polygon_covers && z > u.z_max()) return eye;
    return in_plane(u.plane(), p.first + 0.5, p.second + 0.5, z);
  }
  int corners_hit(const fb::UmbraPolygon& u, const NaiveBox& b, double z) const {
    const int in = corners_inside(u.plane(), b, {z});
    const bool hits_inner = (area(u) < 0) != fail_;
    return hits_inner ? in : 4 - in;
  }
  bool plane_usable(const fb::UmbraPolygon& u) const {
    // The side that is hit must be the far one in z-pass, the near one in z-fail.
    const bool hits_inner = (area(u) < 0) != fail_;
    const double c = hits_inner ? inward_c(u.plane()) : -inward_c(u.plane());
    return fail_ ? c <= 0.0 : c >= 0.0;
  }
  bool umbra_culled(const fb::UmbraPolygon& u, const NaiveBox& b) const {
    if (config_.umbra_cull == UmbraCull::none) return false;
    if (!fail_) {
      return u.z_min() > b.z_max ||
             (plane_usable(u) && b.z_max <= u.z_max() && corners_hit(u, b, b.z_max) == 0);
    }
    return u.z_max() < b.z_min ||
           (plane_usable(u) && b.z_min >= u.z_min() && corners_hit(u, b, b.z_min) == 0);
  }
  bool umbra_accepted(const fb::UmbraPolygon& u, const NaiveBox& b) const {
    if (config_.accept == Accept::none) return false;
    if (!fail_) {
      return u.z_max() < b.z_min ||
             (plane_usable(u) && b.z_min >= u.z_min() && corners_hit(u, b, b.z_min) == 4);
    }
    return u.z_min() > b.z_max ||
           (plane_usable(u) && b.z_max <= u.z_max() && corners_hit(u, b, b.z_max) == 4);
  }

  static std::set<int> face_words(Cull cull) {
    if (cull == Cull::none) return {};
    if (cull == Cull::zmax) return {1};
    return {0, 1};
  }
  std::set<int> umbra_words() const {
    std::set<int> words;
    if (config_.umbra_cull == UmbraCull::zmax) words.insert(1);
    if (config_.accept == Accept::zmin) words.insert(0);
    return words;
  }

  void wedge(std::uint32_t w) {
    const fb::Wedge& wedge = trace_.wedges[w];
    count("wedge_bytes") += traces::wedge_record_bytes(trace_, w);
    if (!single() && wedge.umbra() != kNone && area(trace_.umbra_polygons[wedge.umbra()]) != 0) {
      count("wedge_bytes") += traces::wedge_record_bytes(trace_, w);
    }
    primitive(w, wedge.umbra());
  }

  void primitive(std::uint32_t w, std::uint32_t u) {
    const fb::Wedge* wedge = w == kNone ? nullptr : &trace_.wedges[w];
    const fb::UmbraPolygon* umbra = u == kNone ? nullptr : &trace_.umbra_polygons[u];
    if (umbra != nullptr && !fail_ && umbra->role() != fb::UmbraRole_side) umbra = nullptr;

    std::vector<const fb::Face*> faces;
    std::vector<Pixels> face_pixels;
    Pixels outline;
    for (std::uint32_t i = 0; wedge != nullptr && i < wedge->face_count(); ++i) {
      const fb::Face& face = trace_.faces[wedge->first_face() + i];
      if (area(face) == 0 || (area(face) < 0) == fail_) continue;
      faces.push_back(&face);
      face_pixels.push_back(covered(face));
      outline = join(outline, face_pixels.back());
    }
    const Pixels umbra_pixels = umbra != nullptr ? covered(*umbra) : Pixels{};
    count("pixels_covered") += outline.size() + umbra_pixels.size();
    if (wedge != nullptr && outline.empty() && umbra_pixels.empty()) {
      count("degenerate_wedges") += 1;
    }
    Pixels inside;
    for (const Pixel& p : outline) {
      if (is_inside(*wedge, p)) inside.insert(p);
    }
    count("pixels_inside") += inside.size();
    inside_any_ = join(inside_any_, inside);
    Pixels hits;
    for (const Pixel& p : umbra_pixels) {
      if (hit(*umbra, p)) hits.insert(p);
    }
    for (const Pixel& p : inside) ++contributions_[index(p)];
    for (const Pixel& p : hits) ++contributions_[index(p)];

    bool shared = false;
    if (single() && wedge != nullptr && umbra != nullptr) {
      const bool eye = area(*umbra) < 0;
      shared =
          eye != fail_ || (config_.share == Share::all && wedge->kind() == fb::WedgeKind_coverage);
    }
    std::set<Pixel> tiles;
    for (const Pixel& p : join(outline, umbra_pixels)) {
      tiles.insert({p.first / tile_, p.second / tile_});
    }
    for (const Pixel& t : tiles) {
      tile(t, wedge, umbra, faces, face_pixels, outline, umbra_pixels, inside, hits, shared);
    }
  }

  bool is_inside(const fb::Wedge& wedge, const Pixel& p) const {
    const double z = z_of(p);
    for (std::uint16_t i = 0; i < wedge.plane_count(); ++i) {
      if (!in_plane((*wedge.planes())[i], p.first + 0.5, p.second + 0.5, z)) return false;
    }
    return z >= wedge.z_min() && z <= wedge.z_max();
  }

  void tile(const Pixel& t, const fb::Wedge* wedge, const fb::UmbraPolygon* umbra,
            const std::vector<const fb::Face*>& faces, const std::vector<Pixels>& face_pixels,
            const Pixels& outline, const Pixels& umbra_pixels, const Pixels& inside,
            const Pixels& hits, bool shared) {
    const Pixels all = tile_pixels(t);
    const NaiveBox b = box(t);
    const Pixels u = meet(umbra_pixels, all);
    const bool cap = umbra != nullptr && umbra->role() == fb::UmbraRole_cap;
    std::uint64_t words_read = 0;
    Pixels reads;  // P
    bool first_face = true;
    for (std::size_t i = 0; i < faces.size(); ++i) {
      const Pixels f = meet(face_pixels[i], all);
      if (f.empty()) continue;
      count("tile_visits") += 1;
      std::set<int> words = face_words(config_.cull);
      if (first_face && shared && !u.empty()) words.merge(umbra_words());
      first_face = false;
      words_read += words.size();
      if (face_survives(*wedge, *faces[i], b)) reads = join(reads, f);
    }
    const bool own_visit = !u.empty() && (!shared || !without(u, outline).empty());
    if (own_visit) {
      count("tile_visits") += 1;
      if (!cap) words_read += umbra_words().size();
    }
    count("tile_reads") += words_read;
    if (words_read > 0) visited_.insert(t);

    Pixels umbra_reads;  // Q
    Pixels umbra_writes;
    if (!u.empty() && cap) {
      umbra_writes = u;
    } else if (!u.empty() && umbra_culled(*umbra, b)) {
      count("umbra_visits_culled") += 1;
    } else if (!u.empty() && umbra_accepted(*umbra, b)) {
      count("umbra_visits_accepted") += 1;
      umbra_writes = u;
    } else {
      umbra_reads = u;
      umbra_writes = meet(hits, u);
    }
    const Pixels writes = meet(inside, reads);
    if (shared) {
      read(join(reads, umbra_reads), all);
      write(join(writes, umbra_writes));
    } else {
      read(reads, all);
      read(umbra_reads, all);
      write(writes);
      write(umbra_writes);
      if (!single()) count("stencil_writes") += umbra_writes.size();
    }
    shade(wedge, umbra, umbra_pixels, writes, umbra_writes);
  }

  bool face_survives(const fb::Wedge& wedge, const fb::Face& face, const NaiveBox& b) {
    const Cull cull = config_.cull;
    if (cull == Cull::zmax && face_culled_zmax(face, b)) {
      count("visits_culled_zmax") += 1;
      return false;
    }
    const bool zrange = cull == Cull::zrange || cull == Cull::both || cull == Cull::sat;
    if (zrange && zrange_culled(wedge, b)) {
      count("visits_culled_zrange") += 1;
      return false;
    }
    const bool planes = cull == Cull::planes || cull == Cull::both || cull == Cull::sat;
    if (planes && planes_culled(wedge, b)) {
      count("visits_culled_planes") += 1;
      return false;
    }
    if (cull == Cull::sat && sat_culled(wedge, b)) {
      count("visits_culled_sat") += 1;
      return false;
    }
    if (planes && box_inside(wedge, b)) count("tiles_inside") += 1;
    return true;
  }

  void read(const Pixels& pixels, const Pixels& tile) {
    count("z_reads") += pixels.size();
    if (!pixels.empty()) count("z_reads_whole_tile") += tile.size();
    for (const Pixel& p : pixels) ++result_.z_reads[index(p)];
  }
  void write(const Pixels& pixels) {
    count("li_writes") += pixels.size();
    for (const Pixel& p : pixels) ++result_.li_writes[index(p)];
  }

  void shade(const fb::Wedge* wedge, const fb::UmbraPolygon* umbra, const Pixels& umbra_pixels,
             const Pixels& writes, const Pixels& umbra_writes) {
    for (const Pixel& p : umbra_writes) {
      const int step = (area(*umbra) < 0) != fail_ ? -1 : 1;
      stencil_[index(p)] += step;
      result_.li[index(p)] += step * (std::int64_t{1} << 40);
    }
    if (writes.empty()) return;
    const LightTerms terms = light_terms(trace_, *wedge);
    for (const Pixel& p : writes) {
      const double value = contribution(terms, p.first + 0.5, p.second + 0.5, z_of(p));
      auto word = static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, 40)));
      if (wedge->kind() == fb::WedgeKind_coverage) {
        const bool plus = umbra != nullptr ? inner(*umbra, p, umbra_pixels.count(p) > 0)
                                           : in_plane(wedge->umbra_plane(), p.first + 0.5,
                                                      p.second + 0.5, z_of(p));
        if (!plus) word = -word;
      }
      result_.li[index(p)] += word;
    }
  }

  void finish() {
    const std::uint64_t pixels = trace_.depth.size();
    const bool stencil = !single();
    const auto not_zero = [](auto n) { return n != 0; };
    const auto merged = static_cast<std::uint64_t>(
        stencil ? std::count_if(stencil_.begin(), stencil_.end(), not_zero) : 0);
    count("stencil_reads") = count("stencil_writes");
    count("li_reads") = count("li_writes") - count("stencil_writes");
    count("merge_reads") = stencil ? pixels + merged : 0;
    count("merge_writes") = merged;
    count("clear_writes") = stencil ? 2 * pixels : pixels;
    count("z_reads_min") = static_cast<std::uint64_t>(
        std::count_if(result_.z_reads.begin(), result_.z_reads.end(), not_zero));
    count("li_writes_min") = static_cast<std::uint64_t>(
        std::count_if(result_.li_writes.begin(), result_.li_writes.end(), not_zero));
    count("z_reads_floor") = inside_any_.size();
    count("li_writes_floor") = 0;
    count("li_overflow_pixels") = 0;
    count("contributions_max") = *std::max_element(contributions_.begin(), contributions_.end());
    for (std::size_t i = 0; i < pixels; ++i) {
      const double li = std::ldexp(static_cast<double>(result_.li[i]), -40);
      count("li_writes_floor") += li != 1.0 ? 1 : 0;
      const bool bad = li < -16.0 || li >= 16.0;
      const bool stencil_bad = stencil && (stencil_[i] < -128 || stencil_[i] > 127);
      count("li_overflow_pixels") += bad || stencil_bad ? 1 : 0;
    }
    std::set<int> words = face_words(config_.cull);
    words.merge(umbra_words());
    const auto tiles = static_cast<std::uint64_t>((width_ + tile_ - 1) / tile_) *
                       static_cast<std::uint64_t>((height_ + tile_ - 1) / tile_);
    count("tile_words") = words.empty() ? 0 : tiles * (words.count(0) > 0 ? 2 : 1);
    std::uint64_t build = 0;
    if (config_.tile_build == TileBuild::eager && !words.empty()) build = pixels;
    if (config_.tile_build == TileBuild::lazy) {
      for (const Pixel& t : visited_) build += tile_pixels(t).size();
    }
    count("tile_build_reads") = build;
    const std::uint64_t z_bytes = trace_.header.depth_format == fb::DepthFormat_unorm16 ? 2 : 4;
    count("all_bytes") = z_bytes * (count("z_reads") + count("tile_reads") + build) +
                         2 * (count("li_writes") - count("stencil_writes") + count("li_reads")) +
                         2 * (merged + merged + pixels) + count("stencil_writes") +
                         count("stencil_reads") + (stencil ? pixels + pixels : 0) +
                         count("wedge_bytes");
  }

  const TraceView& trace_;
  const CountConfig& config_;
  bool fail_;
  int width_, height_, tile_;
  NaiveCount result_;
  std::vector<int> stencil_;
  std::vector<std::uint32_t> contributions_;
  Pixels inside_any_;
  std::set<Pixel> visited_;
};

}  // namespace

NaiveCount naive_count(const traces::TraceView& trace, const CountConfig& config, bool fail) {
  return Naive(trace, config, fail).run();
}

}  // namespace wedgesim::model::test
