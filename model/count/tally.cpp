#include "model/count/tally.h"

#include "model/count/bits.h"
#include "model/count/tile_test.h"

namespace wedgesim::model {
namespace {

bool is_planes_kind(Cull cull) {
  return cull == Cull::planes || cull == Cull::both || cull == Cull::sat;
}

}  // namespace

ConfigRun::ConfigRun(const CountConfig& configuration, const ZFrame& frame,
                     const TileDepths& tile_depths, bool maps)
    : config(configuration),
      tiles(&tile_depths),
      face_words(words_of(configuration.cull)),
      umbra_words(umbra_words_of(configuration)),
      z_touched(frame.block_count()),
      li_touched(frame.block_count()) {
  if (config.tile_build == TileBuild::lazy) tiles_visited.resize((tile_depths.count() + 63) / 64);
  if (maps) {
    z_reads.resize(frame.block_count() * kBlockPixels);
    li_writes.resize(z_reads.size());
  }
}

TileTally::TileTally(std::span<ConfigRun* const> runs, const ZFrame& frame, ZMethod method,
                     double one)
    : runs_(runs),
      frame_(frame),
      method_(method),
      one_(one),
      corrections_(runs.size()),
      penumbra_z_reads_(runs.size()) {
  for (const ConfigRun* run : runs) {
    counters_.push_back(std::make_unique<Counters>());
    const CountConfig& config = run->config;
    const bool two_or_more = config.cull == Cull::both || config.cull == Cull::sat;
    needs_zmax_ = needs_zmax_ || config.cull == Cull::zmax;
    needs_zrange_ = needs_zrange_ || config.cull == Cull::zrange || two_or_more;
    needs_planes_ = needs_planes_ || is_planes_kind(config.cull);
    needs_sat_ = needs_sat_ || config.cull == Cull::sat;
    planes_first_ = planes_first_ || config.cull == Cull::planes;
    needs_umbra_cull_ = needs_umbra_cull_ || config.umbra_cull == UmbraCull::zmax;
    needs_accept_ = needs_accept_ || config.accept == Accept::zmin;
  }
}

void TileTally::count(const Primitive& primitive, const Footprint& footprint) {
  primitive_ = &primitive;
  footprint_ = &footprint;
  for_each_tile(footprint, runs_.front()->config.tile, part_memory_,
                [this](std::uint32_t tx, std::uint32_t ty, std::span<const TilePart> parts) {
                  parts_ = parts;
                  count_tile(tx, ty);
                });
}

void TileTally::count_tile(std::uint32_t tx, std::uint32_t ty) {
  const TileDepths& tiles = *runs_.front()->tiles;
  tile_ = {};
  tile_.index = tiles.index(tx, ty);
  const Box box = tiles.box(tx, ty);
  tile_.pixels = pixels_in(box);
  for (const TilePart& part : parts_) find_polygons(part);
  needless_visits_ += bit_count(tile_.faces & ~tile_.needed_faces);
  const bool cullable = tile_.umbra && !primitive_->polygon->cap;
  if (cullable && !tile_.umbra_needed) needless_visits_ += 1;
  test_tile(box);
  part_sets_.clear();
  outcomes_.clear();
  for (std::size_t i = 0; i < runs_.size(); ++i) count_run(i);
}

void TileTally::find_polygons(const TilePart& part) {
  const std::uint64_t inside = footprint_->inside(part.block);
  for (std::size_t i = 0; i < primitive_->faces.size(); ++i) {
    const std::uint64_t covered = footprint_->face(part.block, i) & part.bits;
    if (covered != 0) tile_.faces |= std::uint64_t{1} << i;
    if ((covered & inside) != 0) tile_.needed_faces |= std::uint64_t{1} << i;
  }
  const std::uint64_t umbra = footprint_->umbra(part.block) & part.bits;
  if (umbra == 0) return;
  tile_.umbra = true;
  if ((umbra & footprint_->hits(part.block)) != 0) tile_.umbra_needed = true;
  if ((umbra & ~footprint_->outline(part.block)) != 0) tile_.umbra_beyond_faces = true;
}

void TileTally::test_tile(const Box& box) {
  if (tile_.faces != 0) {
    if (needs_zmax_) {
      for_each_bit(tile_.faces, [&](int i) {
        const RasterFace& face = primitive_->faces[static_cast<std::size_t>(i)];
        if (tile_test::culls_zmax(face, box, method_)) tile_.zmax |= std::uint64_t{1} << i;
      });
    }
    if (needs_zrange_) tile_.zrange = tile_test::culls_zrange(*primitive_, box);
    if (needs_planes_ && (!tile_.zrange || planes_first_)) {
      tile_.planes = tile_test::culls_planes(*primitive_, box);
      tile_.inside = !tile_.planes && tile_test::is_inside(*primitive_, box);
    }
    if (needs_sat_ && !tile_.zrange && !tile_.planes) {
      tile_.sat = tile_test::culls_sat(*primitive_, box);
    }
  }
  if (tile_.umbra && !primitive_->polygon->cap) {
    const RasterUmbra& polygon = *primitive_->polygon;
    if (needs_umbra_cull_) tile_.umbra_culled = tile_test::culls_umbra(polygon, box, method_);
    if (needs_accept_) tile_.umbra_accepted = tile_test::accepts_umbra(polygon, box, method_);
  }
}

void TileTally::count_run(std::size_t index) {
  ConfigRun& run = *runs_[index];
  Counters& counters = *counters_[index];
  const CountConfig& config = run.config;
  const bool single = config.mode == Mode::single_pass;
  const bool shared = single && primitive_->shares(config.share == Share::all);
  const std::uint64_t faces = bit_count(tile_.faces);
  const bool own_visit = tile_.umbra && (!shared || tile_.umbra_beyond_faces);
  // A cap is written untested; a shared polygon's test is paid by the first face's visit.
  const unsigned umbra_words =
      primitive_->polygon && primitive_->polygon->cap ? 0 : run.umbra_words;
  std::uint64_t words =
      faces * bit_count(run.face_words) + (own_visit ? bit_count(umbra_words) : 0);
  if (shared && tile_.umbra && faces > 0) {
    words += bit_count(run.face_words | umbra_words) - bit_count(run.face_words);
  }
  counters.tile_visits += faces + (own_visit ? 1 : 0);
  counters.tile_reads += words;
  if (words > 0 && !run.tiles_visited.empty()) {
    set_shared(run.tiles_visited[tile_.index / 64], std::uint64_t{1} << (tile_.index % 64));
  }

  const std::uint64_t surviving = survivors(config, counters);
  const bool untested = is_planes_kind(config.cull) && tile_.inside;
  if (untested) counters.tiles_inside += bit_count(surviving);
  const Outcome& result = outcome(surviving, umbra_state(config, counters), untested);
  counters.z_reads += shared ? result.shared_reads : result.reads + result.umbra_reads;
  penumbra_z_reads_[index] += result.reads;
  const bool reads = result.reads > 0;
  const bool umbra_reads = result.umbra_reads > 0;
  const std::uint64_t whole_tiles =
      shared ? (reads || umbra_reads ? 1 : 0) : (reads ? 1 : 0) + (umbra_reads ? 1 : 0);
  counters.z_reads_whole_tile += whole_tiles * tile_.pixels;
  counters.li_writes += shared ? result.shared_writes : result.writes + result.umbra_writes;
  if (!single) counters.stencil_writes += result.umbra_writes;
  touch(run, result, shared);
  if (result.wrong) correct(index, result);
}

std::uint64_t TileTally::survivors(const CountConfig& config, Counters& counters) const {
  if (tile_.faces == 0 || config.cull == Cull::none) return tile_.faces;
  if (config.cull == Cull::zmax) {
    counters.visits_culled_zmax += bit_count(tile_.zmax);
    return tile_.faces & ~tile_.zmax;
  }
  const std::uint64_t faces = bit_count(tile_.faces);
  if (config.cull != Cull::planes && tile_.zrange) {
    counters.visits_culled_zrange += faces;
    return 0;
  }
  if (config.cull != Cull::zrange && tile_.planes) {
    counters.visits_culled_planes += faces;
    return 0;
  }
  if (config.cull == Cull::sat && tile_.sat) {
    counters.visits_culled_sat += faces;
    return 0;
  }
  return tile_.faces;
}

TileTally::UmbraState TileTally::umbra_state(const CountConfig& config, Counters& counters) const {
  if (!tile_.umbra) return UmbraState::absent;
  if (primitive_->polygon->cap) return UmbraState::accepted;
  if (config.umbra_cull == UmbraCull::zmax && tile_.umbra_culled) {
    counters.umbra_visits_culled += 1;
    return UmbraState::culled;
  }
  if (config.accept == Accept::zmin && tile_.umbra_accepted) {
    counters.umbra_visits_accepted += 1;
    return UmbraState::accepted;
  }
  return UmbraState::read;
}

const TileTally::Outcome& TileTally::outcome(std::uint64_t survivors, UmbraState umbra,
                                             bool untested) {
  for (const Outcome& known : outcomes_) {
    if (known.survivors == survivors && known.umbra == umbra && known.untested == untested) {
      return known;
    }
  }
  Outcome result;
  result.untested = untested;
  result.survivors = survivors;
  result.umbra = umbra;
  result.first_part = part_sets_.size();
  for (const TilePart& part : parts_) {
    PartSets sets{};
    for_each_bit(survivors, [&](int i) {
      sets.reads |= footprint_->face(part.block, static_cast<std::size_t>(i));
    });
    sets.reads &= part.bits;
    sets.writes = untested ? sets.reads : sets.reads & footprint_->inside(part.block);
    const std::uint64_t covered = footprint_->umbra(part.block) & part.bits;
    const std::uint64_t hits = footprint_->hits(part.block) & part.bits;
    if (umbra == UmbraState::read) sets.umbra_reads = covered;
    if (umbra == UmbraState::read) sets.umbra_writes = hits;
    if (umbra == UmbraState::accepted) sets.umbra_writes = covered;
    result.reads += bit_count(sets.reads);
    result.umbra_reads += bit_count(sets.umbra_reads);
    result.shared_reads += bit_count(sets.reads | sets.umbra_reads);
    result.writes += bit_count(sets.writes);
    result.umbra_writes += bit_count(sets.umbra_writes);
    result.shared_writes += bit_count(sets.writes | sets.umbra_writes);
    result.wrong = result.wrong || sets.umbra_writes != hits ||
                   sets.writes != (footprint_->inside(part.block) & part.bits);
    part_sets_.push_back(sets);
  }
  outcomes_.push_back(result);
  return outcomes_.back();
}

void TileTally::touch(ConfigRun& run, const Outcome& outcome, bool shared) const {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const PartSets& sets = part_sets_[outcome.first_part + k];
    const Block& at = footprint_->blocks()[parts_[k].block];
    const std::size_t block = frame_.block(at.bx, at.by);
    const std::uint64_t z = sets.reads | sets.umbra_reads;
    const std::uint64_t li = sets.writes | sets.umbra_writes;
    if (z != 0) set_shared(run.z_touched[block], z);
    if (li != 0) set_shared(run.li_touched[block], li);
    if (run.z_reads.empty()) continue;
    const auto draw = [&](std::vector<std::uint32_t>& map, std::uint64_t bits) {
      for_each_bit(bits, [&](int bit) {
        add_shared(map[block * kBlockPixels + static_cast<std::size_t>(bit)], 1);
      });
    };
    draw(run.z_reads, z);
    draw(run.li_writes, li);
    if (shared) continue;
    draw(run.z_reads, sets.reads & sets.umbra_reads);
    draw(run.li_writes, sets.writes & sets.umbra_writes);
  }
}

// By the scalar functions: the footprint knows no sign of a pixel outside the wedge.
std::int64_t TileTally::signed_word(std::size_t block, int bit) const {
  const Block& at = footprint_->blocks()[block];
  const double x = centre_x(at, bit);
  const double y = centre_y(at, bit);
  const double z = at.z[bit];
  const std::int64_t word = to_word(contribution(primitive_->terms, x, y, z), one_);
  if (!primitive_->coverage) return word;
  const bool covered = (footprint_->umbra(block) >> bit & 1) != 0;
  const bool inner = primitive_->polygon ? is_inner(*primitive_->polygon, covered, x, y, z)
                                         : primitive_->inner.inside(x, y, z);
  return inner ? word : -word;
}

void TileTally::correct(std::size_t run, const Outcome& outcome) {
  for (std::size_t k = 0; k < parts_.size(); ++k) {
    const TilePart& part = parts_[k];
    const PartSets& sets = part_sets_[outcome.first_part + k];
    const Block& at = footprint_->blocks()[part.block];
    const std::size_t first = frame_.block(at.bx, at.by) * kBlockPixels;
    const std::uint64_t inside = footprint_->inside(part.block) & part.bits;
    for_each_bit(inside ^ sets.writes, [&](int bit) {
      const std::int64_t word = signed_word(part.block, bit);
      const bool lost = (inside >> bit & 1) != 0;
      corrections_[run].push_back({first + static_cast<std::size_t>(bit), lost ? -word : word, 0});
    });
    const std::uint64_t hits = footprint_->hits(part.block) & part.bits;
    if (hits == sets.umbra_writes) continue;
    const std::int32_t step = primitive_->polygon->stencil_step;
    for_each_bit(hits ^ sets.umbra_writes, [&](int bit) {
      const bool lost = (hits >> bit & 1) != 0;
      corrections_[run].push_back({first + static_cast<std::size_t>(bit), 0, lost ? -step : step});
    });
  }
}

}  // namespace wedgesim::model
