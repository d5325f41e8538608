#pragma once

#include <cstdint>
#include <memory>
#include <span>
#include <vector>

#include "model/count/config.h"
#include "model/count/counters.h"
#include "model/count/light_image.h"
#include "model/count/tile_walk.h"

namespace wedgesim::model {

/// Words of {zmin, zmax} that tests name, in z-pass; z-fail mirrors the two, their number stays.
inline constexpr unsigned kZmaxWord = 1;
inline constexpr unsigned kZminWord = 2;
constexpr unsigned words_of(Cull cull) {
  if (cull == Cull::none) return 0;
  return cull == Cull::zmax ? kZmaxWord : kZmaxWord | kZminWord;
}
constexpr unsigned umbra_words_of(const CountConfig& config) {
  return (config.umbra_cull == UmbraCull::zmax ? kZmaxWord : 0) |
         (config.accept == Accept::zmin ? kZminWord : 0);
}

/// What all threads fill for one configuration.
struct ConfigRun {
  ConfigRun(const CountConfig& configuration, const ZFrame& frame, const TileDepths& tile_depths,
            bool maps);

  CountConfig config;
  const TileDepths* tiles;
  unsigned face_words, umbra_words;
  std::vector<std::uint64_t> z_touched, li_touched;  // a word a block
  std::vector<std::uint64_t> tiles_visited;          // a bit a tile, if built lazily
  std::vector<std::uint32_t> z_reads, li_writes;     // maps in block order, or empty
};

/// Counts the tiles of one primitive after another, for every configuration of one tile size. One
/// of these a thread.
class TileTally {
 public:
  /// \param runs  of the same tile size
  /// \param one   Datapath::one()
  TileTally(std::span<ConfigRun* const> runs, const ZFrame& frame, ZMethod method, double one);

  void count(const Primitive& primitive, const Footprint& footprint);

  Counters& counters(std::size_t run) { return *counters_[run]; }
  /// CountResult::needless_visits, of any of the runs.
  std::uint64_t needless_visits() const { return needless_visits_; }
  /// CountResult::penumbra_z_reads.
  std::uint64_t penumbra_z_reads(std::size_t run) const { return penumbra_z_reads_[run]; }
  const std::vector<Correction>& corrections(std::size_t run) const { return corrections_[run]; }

 private:
  enum class UmbraState : std::uint8_t { absent, read, culled, accepted };

  /// The pixels of one tile part under one outcome of the tests.
  struct PartSets {
    std::uint64_t reads;         // P
    std::uint64_t umbra_reads;   // Q
    std::uint64_t writes;        // of P: inside, or untested
    std::uint64_t umbra_writes;  // hit, or accepted
  };
  /// One outcome of the tests in a tile; many configurations have the same.
  struct Outcome {
    std::uint64_t survivors = 0;  // faces
    UmbraState umbra = UmbraState::absent;
    bool untested = false;       // the faces' pixels skip their inside tests
    std::size_t first_part = 0;  // in part_sets_
    std::uint64_t reads = 0, umbra_reads = 0, shared_reads = 0;
    std::uint64_t writes = 0, umbra_writes = 0, shared_writes = 0;
    bool wrong = false;  // a pixel is lost or gained
  };
  /// The tile at hand and what the tests that any configuration needs say of it.
  struct Tile {
    std::size_t index = 0;
    std::uint64_t pixels = 0;
    std::uint64_t faces = 0;          // that cover a pixel
    std::uint64_t needed_faces = 0;   // that cover a pixel inside the wedge
    bool umbra = false;               // the polygon covers a pixel
    bool umbra_needed = false;        // it hits one
    bool umbra_beyond_faces = false;  // one that no face covers
    std::uint64_t zmax = 0;           // faces culled
    bool zrange = false, planes = false, sat = false, inside = false;
    bool umbra_culled = false, umbra_accepted = false;
  };

  void count_tile(std::uint32_t tx, std::uint32_t ty);
  void find_polygons(const TilePart& part);
  void test_tile(const Box& box);
  void count_run(std::size_t run);
  std::uint64_t survivors(const CountConfig& config, Counters& counters) const;
  UmbraState umbra_state(const CountConfig& config, Counters& counters) const;
  const Outcome& outcome(std::uint64_t survivors, UmbraState umbra, bool untested);
  void touch(ConfigRun& run, const Outcome& outcome, bool shared) const;
  std::int64_t signed_word(std::size_t block, int bit) const;
  void correct(std::size_t run, const Outcome& outcome);

  std::span<ConfigRun* const> runs_;
  const ZFrame& frame_;
  ZMethod method_;
  double one_;
  // Tests that some configuration enables; no other is run.
  bool needs_zmax_ = false, needs_zrange_ = false, needs_planes_ = false, needs_sat_ = false;
  bool planes_first_ = false;  // a configuration tests planes without zrange before
  bool needs_umbra_cull_ = false, needs_accept_ = false;
  std::vector<std::unique_ptr<Counters>> counters_;
  std::vector<std::vector<Correction>> corrections_;
  std::uint64_t needless_visits_ = 0;
  std::vector<std::uint64_t> penumbra_z_reads_;
  const Primitive* primitive_ = nullptr;
  const Footprint* footprint_ = nullptr;
  Tile tile_;
  std::span<const TilePart> parts_;
  std::vector<TilePart> part_memory_;
  std::vector<PartSets> part_sets_;
  std::vector<Outcome> outcomes_;
};

}  // namespace wedgesim::model
