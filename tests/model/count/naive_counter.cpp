#include "tests/model/count/naive_counter.h"

#include <algorithm>
#include <cmath>
#include <set>
#include <utility>

#include "model/count/contribution.h"
#include "tests/model/count/naive_frame.h"
#include "traces/record.h"

namespace wedgesim::model::test {
namespace {

using traces::kNone;
using traces::TraceView;

class Naive {
 public:
  Naive(const TraceView& trace, const CountConfig& config, bool fail)
      : trace_(trace),
        config_(config),
        fail_(fail),
        tile_(static_cast<int>(config.tile)),
        frame_(trace, tile_, fail) {
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
    if (!single() && wedge.umbra() != kNone &&
        frame_.area(trace_.umbra_polygons[wedge.umbra()]) != 0) {
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
      if (frame_.area(face) == 0 || (frame_.area(face) < 0) == fail_) continue;
      faces.push_back(&face);
      face_pixels.push_back(frame_.covered(face));
      outline = join(outline, face_pixels.back());
    }
    const Pixels umbra_pixels = umbra != nullptr ? frame_.covered(*umbra) : Pixels{};
    count("pixels_covered") += outline.size() + umbra_pixels.size();
    if (wedge != nullptr && outline.empty() && umbra_pixels.empty()) {
      count("degenerate_wedges") += 1;
    }
    Pixels inside;
    for (const Pixel& p : outline) {
      if (frame_.is_inside(*wedge, p)) inside.insert(p);
    }
    count("pixels_inside") += inside.size();
    inside_any_ = join(inside_any_, inside);
    Pixels hits;
    for (const Pixel& p : umbra_pixels) {
      if (frame_.hit(*umbra, p)) hits.insert(p);
    }
    for (const Pixel& p : inside) ++contributions_[frame_.index(p)];
    for (const Pixel& p : hits) ++contributions_[frame_.index(p)];

    bool shared = false;
    if (single() && wedge != nullptr && umbra != nullptr) {
      const bool eye = frame_.area(*umbra) < 0;
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

  void tile(const Pixel& t, const fb::Wedge* wedge, const fb::UmbraPolygon* umbra,
            const std::vector<const fb::Face*>& faces, const std::vector<Pixels>& face_pixels,
            const Pixels& outline, const Pixels& umbra_pixels, const Pixels& inside,
            const Pixels& hits, bool shared) {
    const Pixels all = frame_.tile_pixels(t);
    const NaiveBox b = frame_.box(t);
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
    } else if (!u.empty() && config_.umbra_cull != UmbraCull::none &&
               frame_.umbra_culled(*umbra, b)) {
      count("umbra_visits_culled") += 1;
    } else if (!u.empty() && config_.accept != Accept::none && frame_.umbra_accepted(*umbra, b)) {
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
    if (cull == Cull::zmax && frame_.face_culled_zmax(face, b)) {
      count("visits_culled_zmax") += 1;
      return false;
    }
    const bool zrange = cull == Cull::zrange || cull == Cull::both || cull == Cull::sat;
    if (zrange && frame_.zrange_culled(wedge, b)) {
      count("visits_culled_zrange") += 1;
      return false;
    }
    const bool planes = cull == Cull::planes || cull == Cull::both || cull == Cull::sat;
    if (planes && frame_.planes_culled(wedge, b)) {
      count("visits_culled_planes") += 1;
      return false;
    }
    if (cull == Cull::sat && frame_.sat_culled(wedge, b)) {
      count("visits_culled_sat") += 1;
      return false;
    }
    if (planes && frame_.box_inside(wedge, b)) count("tiles_inside") += 1;
    return true;
  }

  void read(const Pixels& pixels, const Pixels& tile) {
    count("z_reads") += pixels.size();
    if (!pixels.empty()) count("z_reads_whole_tile") += tile.size();
    for (const Pixel& p : pixels) ++result_.z_reads[frame_.index(p)];
  }
  void write(const Pixels& pixels) {
    count("li_writes") += pixels.size();
    for (const Pixel& p : pixels) ++result_.li_writes[frame_.index(p)];
  }

  void shade(const fb::Wedge* wedge, const fb::UmbraPolygon* umbra, const Pixels& umbra_pixels,
             const Pixels& writes, const Pixels& umbra_writes) {
    for (const Pixel& p : umbra_writes) {
      const int step = (frame_.area(*umbra) < 0) != fail_ ? -1 : 1;
      stencil_[frame_.index(p)] += step;
      result_.li[frame_.index(p)] += step * (std::int64_t{1} << 40);
    }
    if (writes.empty()) return;
    const LightTerms terms = light_terms(trace_, *wedge);
    for (const Pixel& p : writes) {
      const double value = contribution(terms, p.first + 0.5, p.second + 0.5, frame_.z_of(p));
      auto word = static_cast<std::int64_t>(std::nearbyint(std::ldexp(value, 40)));
      if (wedge->kind() == fb::WedgeKind_coverage) {
        const bool plus = umbra != nullptr ? frame_.inner(*umbra, p, umbra_pixels.count(p) > 0)
                                           : frame_.in_plane(wedge->umbra_plane(), p.first + 0.5,
                                                             p.second + 0.5, frame_.z_of(p));
        if (!plus) word = -word;
      }
      result_.li[frame_.index(p)] += word;
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
    const std::uint64_t tiles = frame_.tiles();
    count("tile_words") = words.empty() ? 0 : tiles * (words.count(0) > 0 ? 2 : 1);
    std::uint64_t build = 0;
    if (config_.tile_build == TileBuild::eager && !words.empty()) build = pixels;
    if (config_.tile_build == TileBuild::lazy) {
      for (const Pixel& t : visited_) build += frame_.tile_pixels(t).size();
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
  int tile_;
  NaiveFrame frame_;
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
