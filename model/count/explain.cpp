#include "model/count/explain.h"

#include <fmt/format.h>

#include "base/error.h"
#include "model/count/count.h"
#include "model/count/tile_test.h"
#include "model/count/z_frame.h"
#include "traces/depth.h"

namespace wedgesim::model {
namespace {

using traces::TraceView;

class Pixel {
 public:
  Pixel(const TraceView& trace, Explanation& explanation)
      : trace_(trace),
        explanation_(explanation),
        config_(explanation.config),
        centre_x_(explanation.x + 0.5),
        centre_y_(explanation.y + 0.5) {}

  void add(const Primitive& primitive) {
    WedgeExplanation wedge;
    wedge.wedge = primitive.wedge;
    add_faces(primitive, wedge);
    const bool covered = primitive.polygon && covers(primitive.polygon->outline);
    if (wedge.faces.empty() && !covered) return;
    if (!wedge.faces.empty()) add_planes(primitive, wedge);
    wedge.inner = is_inner_here(primitive, covered);
    if (covered) wedge.umbra = explain_umbra(primitive, wedge.inner);
    account(primitive, wedge);
    explanation_.z_reads += wedge.z_reads;
    explanation_.li_writes += wedge.li_writes;
    const std::int64_t one = std::int64_t{1} << 40;
    explanation_.word += wedge.words + (wedge.umbra ? wedge.umbra->step * one : 0);
    explanation_.wedges.push_back(std::move(wedge));
  }

 private:
  bool covers(const Outline& outline) const {
    return outline.covers(explanation_.x, explanation_.y);
  }

  Cull culled_by(const Primitive& primitive, const RasterFace& face) const {
    const Cull cull = config_.cull;
    const Box& box = explanation_.tile;
    const bool all = cull == Cull::both || cull == Cull::sat;
    if (cull == Cull::zmax && tile_test::culls_zmax(face, box, explanation_.method)) {
      return Cull::zmax;
    }
    if ((all || cull == Cull::zrange) && tile_test::culls_zrange(primitive, box)) {
      return Cull::zrange;
    }
    if ((all || cull == Cull::planes) && tile_test::culls_planes(primitive, box)) {
      return Cull::planes;
    }
    if (cull == Cull::sat && tile_test::culls_sat(primitive, box)) return Cull::sat;
    return Cull::none;
  }

  void add_faces(const Primitive& primitive, WedgeExplanation& wedge) const {
    for (std::size_t i = 0; i < primitive.faces.size(); ++i) {
      if (!covers(primitive.faces[i].outline)) continue;
      wedge.faces.push_back({primitive.face_numbers[i], culled_by(primitive, primitive.faces[i])});
    }
  }

  void add_planes(const Primitive& primitive, WedgeExplanation& wedge) const {
    const traces::fb::Wedge& source = trace_.wedges[*primitive.wedge];
    wedge.kind = source.kind();
    wedge.z = primitive.z;
    wedge.inside = explanation_.z >= wedge.z.min && explanation_.z <= wedge.z.max;
    for (std::size_t i = 0; i < primitive.planes.size(); ++i) {
      const Plane& plane = primitive.planes[i];
      const bool inside = plane.inside(centre_x_, centre_y_, explanation_.z);
      wedge.planes.push_back({(*source.planes())[static_cast<std::uint16_t>(i)],
                              plane.value(centre_x_, centre_y_, explanation_.z), inside});
      wedge.inside = wedge.inside && inside;
    }
  }

  bool is_inner_here(const Primitive& primitive, bool covered) const {
    if (primitive.polygon) {
      return is_inner(*primitive.polygon, covered, centre_x_, centre_y_, explanation_.z);
    }
    return primitive.inner.inside(centre_x_, centre_y_, explanation_.z);
  }

  UmbraExplanation explain_umbra(const Primitive& primitive, bool inner) const {
    using Outcome = UmbraExplanation::Outcome;
    const RasterUmbra& polygon = *primitive.polygon;
    UmbraExplanation umbra;
    umbra.polygon = *primitive.umbra;
    umbra.role = trace_.umbra_polygons[umbra.polygon].role();
    umbra.eye_facing = polygon.eye_facing;
    umbra.value = polygon.inner.value(centre_x_, centre_y_, explanation_.z);
    umbra.interval_decides = explanation_.z < polygon.z.min || explanation_.z > polygon.z.max;
    umbra.inner = inner;
    umbra.hit = polygon.cap || inner == polygon.hits_inner;
    umbra.shared =
        config_.mode == Mode::single_pass && primitive.shares(config_.share == Share::all);
    const Box& box = explanation_.tile;
    if (polygon.cap) {
      umbra.outcome = Outcome::cap;
    } else if (config_.umbra_cull == UmbraCull::zmax &&
               tile_test::culls_umbra(polygon, box, explanation_.method)) {
      umbra.outcome = Outcome::culled;
    } else if (config_.accept == Accept::zmin &&
               tile_test::accepts_umbra(polygon, box, explanation_.method)) {
      umbra.outcome = Outcome::accepted;
    }
    umbra.written = umbra.outcome == Outcome::accepted || umbra.outcome == Outcome::cap ||
                    (umbra.outcome == Outcome::read && umbra.hit);
    umbra.step = umbra.written ? polygon.stencil_step : 0;
    return umbra;
  }

  void account(const Primitive& primitive, WedgeExplanation& wedge) const {
    bool reads = false;
    for (const FaceExplanation& face : wedge.faces) reads = reads || face.culled_by == Cull::none;
    const bool writes = reads && wedge.inside;
    if (writes) {
      wedge.words = to_word(contribution(primitive.terms, centre_x_, centre_y_, explanation_.z),
                            word_one(DatapathKind::exact));
      if (primitive.coverage && !wedge.inner) wedge.words = -wedge.words;
    }
    const bool umbra_reads = wedge.umbra && wedge.umbra->outcome == UmbraExplanation::Outcome::read;
    const bool umbra_writes = wedge.umbra && wedge.umbra->written;
    const bool shared = wedge.umbra && wedge.umbra->shared;
    const auto accesses = [shared](bool a, bool b) {
      return shared ? (a || b ? 1U : 0U) : (a ? 1U : 0U) + (b ? 1U : 0U);
    };
    wedge.z_reads = accesses(reads, umbra_reads);
    wedge.li_writes = accesses(writes, umbra_writes);
  }

  const TraceView& trace_;
  Explanation& explanation_;
  const CountConfig& config_;
  double centre_x_, centre_y_;
};

}  // namespace

Explanation explain(const TraceView& trace, int x, int y, const CountConfig& config) {
  check(config);
  const auto width = static_cast<int>(trace.header.width);
  const auto height = static_cast<int>(trace.header.height);
  if (x < 0 || y < 0 || x >= width || y >= height) {
    throw InputError("--pixel", fmt::format("{},{} is outside the frame", x, y),
                     fmt::format("0,0 to {},{}", width - 1, height - 1));
  }
  Explanation explanation;
  explanation.x = x;
  explanation.y = y;
  explanation.config = config;
  explanation.method = resolve_z(trace, config.z);
  const std::size_t pixel =
      static_cast<std::size_t>(y) * trace.header.width + static_cast<std::size_t>(x);
  explanation.depth_word = trace.depth[pixel];
  explanation.z = traces::decode_depth(trace.header.depth_format, explanation.depth_word);
  explanation.sky = explanation.depth_word == traces::sky_word(trace.header.depth_format);
  explanation.tile = TileDepths(ZFrame(trace), config.tile)
                         .box(static_cast<std::uint32_t>(x) / config.tile,
                              static_cast<std::uint32_t>(y) / config.tile);
  explanation.word = std::int64_t{1} << 40;
  if (!trace.expected_li.empty()) explanation.expected = trace.expected_li[pixel];
  Pixel at(trace, explanation);
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    at.add(wedge_primitive(trace, explanation.method, i));
  }
  for (std::uint32_t i : lone_polygons(trace, explanation.method)) {
    at.add(lone_primitive(trace, explanation.method, i));
  }
  return explanation;
}

}  // namespace wedgesim::model
