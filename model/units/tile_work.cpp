#include "model/units/tile_work.h"

#include <algorithm>
#include <bit>

#include "model/count/traffic.h"
#include "model/units/tile_decision.h"

namespace wedgesim::model::units {
namespace {

std::uint64_t bit_count(std::uint64_t set) {
  return static_cast<std::uint64_t>(std::popcount(set));
}

constexpr unsigned kZmax = 1;
constexpr unsigned kZmin = 2;

unsigned face_words(Cull cull) {
  if (cull == Cull::none) return 0;
  return cull == Cull::zmax ? kZmax : kZmax | kZmin;
}

unsigned umbra_words(const CountConfig& config) {
  return (config.umbra_cull == UmbraCull::zmax ? kZmax : 0) |
         (config.accept == Accept::zmin ? kZmin : 0);
}

bool may_be_untested(Cull cull) {
  return cull == Cull::planes || cull == Cull::both || cull == Cull::sat;
}

}  // namespace

unsigned BlockWork::pixels(bool shared) const {
  const std::uint64_t faces = reads | writes;
  const std::uint64_t umbra = umbra_reads | umbra_writes;
  return static_cast<unsigned>(shared ? bit_count(faces | umbra)
                                      : bit_count(faces) + bit_count(umbra));
}

TileDatapath::TileDatapath(const traces::TraceView& trace, const CountConfig& config, bool z_fail,
                           const datapath::Formats& formats)
    : trace_(trace),
      config_(config),
      z_fail_(z_fail),
      formats_(formats),
      round_(formats.round()),
      depth_(trace, static_cast<int>(config.tile)),
      li_(trace.depth.size(), formats.li.one()),
      stencil_(config.mode == Mode::three_pass ? trace.depth.size() : 0),
      true_li_(trace.depth.size(), formats.li.one()),
      true_stencil_(stencil_.size()),
      blocks_(depth_.block_count()),
      contributions_(trace.depth.size()),
      tiles_read_(depth_.tile_count()),
      covering_wedges_(trace.wedges.size()) {}

bool TileDatapath::shared() const {
  return pass_ == Pass::single && primitive_->wedge && primitive_->umbra &&
         (primitive_->umbra->hits_inner || (config_.share == Share::all && primitive_->coverage));
}

void TileDatapath::begin(const SetupPrimitive& primitive, Pass pass) {
  primitive_ = &primitive;
  pass_ = pass;
  covered_any_ = false;
  counters_.wedge_bytes += primitive.record_bytes;
}

void TileDatapath::end() {
  if (primitive_->wedge && covered_any_) covering_wedges_[*primitive_->wedge] = true;
}

TileSpan TileDatapath::begin_row(int ty) {
  ty_ = ty;
  const PixelBox row = depth_.row(ty);
  TileSpan hull;
  const auto span_of = [&](const SetupPolygon& polygon, bool walked) {
    const TileSpan span = touched(polygon, row, depth_.tile());
    if (walked && !span.empty()) {
      hull = hull.empty()
                 ? span
                 : TileSpan{std::min(hull.first, span.first), std::max(hull.end, span.end)};
    }
    return span;
  };
  face_spans_.assign(primitive_->faces.size(), {});
  for (std::size_t i = 0; faces_active() && i < face_spans_.size(); ++i) {
    face_spans_[i] = span_of(primitive_->faces[i].polygon, true);
  }
  umbra_span_ = {};
  if (needs_umbra()) umbra_span_ = span_of(primitive_->umbra->polygon, umbra_active());
  return hull;
}

bool TileDatapath::touches(int tx) const {
  return (umbra_active() && umbra_span_.holds(tx)) ||
         std::any_of(face_spans_.begin(), face_spans_.end(),
                     [tx](const TileSpan& span) { return span.holds(tx); });
}

void TileDatapath::cover(int tx) {
  parts_.clear();
  face_sets_.clear();
  umbra_sets_.clear();
  const PixelBox tile = depth_.pixels(tx, ty_);
  const std::size_t faces = face_spans_.size();
  for (int y = tile.y0; y < tile.y1; y = (y / 8 + 1) * 8) {
    for (int x = tile.x0; x < tile.x1; x = (x / 8 + 1) * 8) {
      const BlockPart part{x, y, std::min((x / 8 + 1) * 8, tile.x1),
                           std::min((y / 8 + 1) * 8, tile.y1)};
      std::uint64_t any = 0;
      for (std::size_t i = 0; i < faces; ++i) {
        const bool may = face_spans_[i].holds(tx);
        face_sets_.push_back(may ? covered(primitive_->faces[i].polygon, part) : 0);
        any |= face_sets_.back();
      }
      const std::uint64_t umbra =
          umbra_span_.holds(tx) ? covered(primitive_->umbra->polygon, part) : 0;
      if (umbra_active()) any |= umbra;
      if (any == 0) {
        face_sets_.resize(face_sets_.size() - faces);
        continue;
      }
      umbra_sets_.push_back(umbra);
      parts_.push_back(part);
    }
  }
}

bool TileDatapath::process(int tx, TileWork& work, std::vector<BlockWork>& blocks) {
  cover(tx);
  if (parts_.empty()) return false;
  covered_any_ = true;
  work.tile = static_cast<std::uint32_t>(depth_.tile_index(tx, ty_));
  work.first_block = static_cast<std::uint32_t>(blocks.size());
  work.shared = shared();
  count_visits(work);
  const datapath::FixedBox box = depth_.box(tx, ty_);
  const Tests tests = test(box);
  bool reads = false;
  bool umbra_reads = false;
  work.pixels = 0;
  for (std::size_t part = 0; tests.any() && part < parts_.size(); ++part) {
    const BlockWork block = work_on_part(part, tests, work.shared);
    if ((block.reads | block.umbra_reads | block.umbra_writes) == 0) continue;
    blocks.push_back(block);
    work.pixels += block.pixels(work.shared);
    reads = reads || block.reads != 0;
    umbra_reads = umbra_reads || block.umbra_reads != 0;
  }
  work.blocks = static_cast<std::uint16_t>(blocks.size() - work.first_block);
  const PixelBox p = depth_.pixels(tx, ty_);
  const auto pixels = static_cast<std::uint64_t>((p.x1 - p.x0) * (p.y1 - p.y0));
  const unsigned tiles =
      work.shared ? (reads || umbra_reads ? 1 : 0) : (reads ? 1U : 0U) + (umbra_reads ? 1U : 0U);
  counters_.z_reads_whole_tile += tiles * pixels;
  return true;
}

void TileDatapath::count_visits(TileWork& work) {
  const std::size_t faces = primitive_->faces.size();
  std::uint64_t faces_here = 0;
  std::uint64_t umbra = 0;
  std::uint64_t umbra_beyond = 0;
  for (std::size_t part = 0; part < parts_.size(); ++part) {
    std::uint64_t outline = 0;
    for (std::size_t i = 0; i < faces; ++i) {
      const std::uint64_t set = face_sets_[part * faces + i];
      outline |= set;
      if (set != 0) faces_here |= std::uint64_t{1} << i;
    }
    const std::uint64_t own = umbra_active() ? umbra_sets_[part] : 0;
    umbra |= own;
    umbra_beyond |= own & ~outline;
    counters_.pixels_covered += bit_count(outline) + bit_count(own);
  }
  const bool own_visit = umbra != 0 && (!work.shared || umbra_beyond != 0);
  const unsigned for_face = face_words(config_.cull);
  const bool cap = umbra_active() && primitive_->umbra->cap;
  const unsigned for_umbra = cap ? 0 : umbra_words(config_);
  const std::uint64_t visits = bit_count(faces_here) + (own_visit ? 1 : 0);
  std::uint64_t words =
      bit_count(faces_here) * bit_count(for_face) + (own_visit ? bit_count(for_umbra) : 0);
  if (work.shared && umbra != 0 && faces_here != 0) words += bit_count(for_umbra & ~for_face);
  // At most 64 faces and an umbra polygon, two words each.
  work.visits = static_cast<std::uint8_t>(visits);
  work.words = static_cast<std::uint8_t>(words);
  counters_.tile_visits += work.visits;
  counters_.tile_reads += work.words;
  if (work.words > 0) tiles_read_[work.tile] = true;
}

TileDatapath::Tests TileDatapath::test(const datapath::FixedBox& box) {
  Tests tests;
  const std::size_t faces = primitive_->faces.size();
  const auto covers = [&](std::size_t face) {
    for (std::size_t part = 0; part < parts_.size(); ++part) {
      if (face_sets_[part * faces + face] != 0) return true;
    }
    return false;
  };
  for (std::size_t i = 0; i < faces; ++i) {
    if (!covers(i)) continue;
    switch (cull_face(config_.cull, *primitive_, primitive_->faces[i], box, z_fail_)) {
      case Cull::zmax:
        counters_.visits_culled_zmax += 1;
        break;
      case Cull::zrange:
        counters_.visits_culled_zrange += 1;
        break;
      case Cull::planes:
        counters_.visits_culled_planes += 1;
        break;
      case Cull::sat:
        counters_.visits_culled_sat += 1;
        break;
      default:
        tests.survivors |= std::uint64_t{1} << i;
    }
  }
  tests.untested =
      tests.survivors != 0 && may_be_untested(config_.cull) && inside_wedge(*primitive_, box);
  if (tests.untested) counters_.tiles_inside += bit_count(tests.survivors);
  const bool umbra_here = umbra_active() && std::any_of(umbra_sets_.begin(), umbra_sets_.end(),
                                                        [](std::uint64_t set) { return set != 0; });
  if (!umbra_here) return tests;
  if (primitive_->umbra->cap) {
    tests.accepts_umbra = true;
    return tests;
  }
  const UmbraDecision decision =
      decide_umbra(config_.umbra_cull, config_.accept, *primitive_->umbra, box, z_fail_);
  tests.reads_umbra = decision == UmbraDecision::read;
  tests.accepts_umbra = decision == UmbraDecision::accepted;
  if (decision == UmbraDecision::culled) counters_.umbra_visits_culled += 1;
  if (decision == UmbraDecision::accepted) counters_.umbra_visits_accepted += 1;
  return tests;
}

bool TileDatapath::inside(const datapath::Place& at) const {
  return primitive_->z.holds(at.z) &&
         std::all_of(primitive_->planes.begin(), primitive_->planes.end(),
                     [&](const datapath::FixedPlane& plane) { return plane.inside(at); });
}

// The one predicate: where the umbra polygon covers the pixel, a z outside its interval decides.
bool TileDatapath::inner(const datapath::Place& at, bool covered) const {
  if (!primitive_->umbra) return primitive_->inner.inside(at);
  const SetupUmbra& umbra = *primitive_->umbra;
  if (covered && at.z < umbra.z.min) return !umbra.polygon.eye_facing;
  if (covered && at.z > umbra.z.max) return umbra.polygon.eye_facing;
  return umbra.inner.inside(at);
}

BlockWork TileDatapath::work_on_part(std::size_t index, const Tests& tests, bool shared) {
  const BlockPart& part = parts_[index];
  const std::size_t faces = primitive_->faces.size();
  BlockWork block{
      static_cast<std::uint16_t>(part.bx()), static_cast<std::uint16_t>(part.by()), 0, 0, 0, 0};
  for (std::size_t i = 0; i < faces; ++i) {
    if ((tests.survivors >> i & 1) != 0) block.reads |= face_sets_[index * faces + i];
  }
  const std::uint64_t umbra = umbra_sets_[index];
  if (tests.reads_umbra) block.umbra_reads = umbra;
  if (tests.accepts_umbra) block.umbra_writes = umbra;
  std::uint64_t left = block.reads | block.umbra_reads | block.umbra_writes;
  const int x0 = 8 * part.bx();
  const int y0 = 8 * part.by();
  for (; left != 0; left &= left - 1) {
    const int bit = std::countr_zero(left);
    const std::uint64_t pixel = std::uint64_t{1} << bit;
    const int x = x0 + bit % 8;
    const int y = y0 + bit / 8;
    const datapath::Place at{2 * x + 1, 2 * y + 1, depth_.z(x, y)};
    const bool covered = (umbra & pixel) != 0;
    std::int64_t words = 0;
    if ((block.reads & pixel) != 0 && (tests.untested || inside(at))) {
      block.writes |= pixel;
      contributions_[depth_.index(x, y)] += 1;
      words = formats_.li.of(datapath::contribution(primitive_->light, at, round_));
      if (primitive_->coverage && !inner(at, covered)) words = -words;
    }
    if ((block.umbra_reads & pixel) != 0 && inner(at, true) == primitive_->umbra->hits_inner) {
      block.umbra_writes |= pixel;
    }
    const int step = (block.umbra_writes & pixel) != 0 ? primitive_->umbra->step : 0;
    if (((block.writes | block.umbra_writes) & pixel) != 0) write(x, y, words, step);
    if (step != 0) contributions_[depth_.index(x, y)] += 1;
  }
  BlockSets& sets = blocks_[depth_.block_index(part.bx(), part.by())];
  sets.z_read |= block.reads | block.umbra_reads;
  sets.li_written |= block.writes | block.umbra_writes;
  sets.inside |= block.writes;
  const std::uint64_t umbra_writes = bit_count(block.umbra_writes);
  counters_.z_reads += shared ? bit_count(block.reads | block.umbra_reads)
                              : bit_count(block.reads) + bit_count(block.umbra_reads);
  counters_.li_writes += shared ? bit_count(block.writes | block.umbra_writes)
                                : bit_count(block.writes) + umbra_writes;
  if (config_.mode == Mode::three_pass) counters_.stencil_writes += umbra_writes;
  counters_.pixels_inside += bit_count(block.writes);
  return block;
}

void TileDatapath::write(int x, int y, std::int64_t li_words, int step) {
  const std::size_t i = depth_.index(x, y);
  if (config_.mode == Mode::three_pass) {
    const datapath::LiWord stencil{formats_.stencil_bits, 0};
    true_stencil_[i] += step;
    stencil_[i] = static_cast<std::int32_t>(stencil.wrap(stencil_[i] + step));
    true_li_[i] += step * formats_.li.one();
  } else {
    li_words += step * formats_.li.one();
  }
  true_li_[i] += li_words;
  li_[i] = formats_.li.wrap(li_[i] + li_words);
}

bool TileDatapath::merge(int bx, int by) {
  bool any = false;
  for (int y = 8 * by; y < std::min(8 * by + 8, depth_.height()); ++y) {
    for (int x = 8 * bx; x < std::min(8 * bx + 8, depth_.width()); ++x) {
      const std::size_t i = depth_.index(x, y);
      if (stencil_[i] == 0) continue;
      any = true;
      counters_.merge_writes += 1;
      li_[i] = formats_.li.wrap(li_[i] + stencil_[i] * formats_.li.one());
    }
  }
  return any;
}

void TileDatapath::finish() {
  const std::size_t pixels = trace_.depth.size();
  const bool three = config_.mode == Mode::three_pass;
  counters_.degenerate_wedges = static_cast<std::uint64_t>(
      std::count(covering_wedges_.begin(), covering_wedges_.end(), false));
  const unsigned words = face_words(config_.cull) | umbra_words(config_);
  const std::uint64_t stored = words == 0 ? 0 : ((words & kZmin) != 0 ? 2 : 1);
  counters_.tile_words = stored * depth_.tile_count();
  if (words != 0 && config_.tile_build == TileBuild::eager) counters_.tile_build_reads = pixels;
  if (words != 0 && config_.tile_build == TileBuild::lazy) {
    const int tiles_x = (depth_.width() + depth_.tile() - 1) / depth_.tile();
    for (std::size_t i = 0; i < tiles_read_.size(); ++i) {
      if (!tiles_read_[i]) continue;
      const auto tile = static_cast<int>(i);
      const PixelBox p = depth_.pixels(tile % tiles_x, tile / tiles_x);
      counters_.tile_build_reads += static_cast<std::uint64_t>((p.x1 - p.x0) * (p.y1 - p.y0));
    }
  }
  for (const BlockSets& sets : blocks_) {
    counters_.z_reads_min += bit_count(sets.z_read);
    counters_.z_reads_floor += bit_count(sets.inside);
    counters_.li_writes_min += bit_count(sets.li_written);
  }
  const datapath::LiWord stencil{formats_.stencil_bits, 0};
  for (std::size_t i = 0; i < pixels; ++i) {
    counters_.contributions_max =
        std::max<std::uint64_t>(counters_.contributions_max.value(), contributions_[i]);
    counters_.li_writes_floor += true_li_[i] != formats_.li.one() ? 1 : 0;
    const bool bad = !formats_.li.holds(true_li_[i]) || (three && !stencil.holds(true_stencil_[i]));
    counters_.li_overflow_pixels += bad ? 1 : 0;
    if (bad && !first_overflow_) {
      const auto pixel = static_cast<int>(i);
      first_overflow_ = {pixel % depth_.width(), pixel / depth_.width()};
    }
  }
  finish_traffic(counters_, config_.mode, trace_.header.depth_format, pixels,
                 counters_.merge_writes.value(),
                 {bytes_of_bits(formats_.li.bits()), bytes_of_bits(formats_.stencil_bits)});
}

}  // namespace wedgesim::model::units
