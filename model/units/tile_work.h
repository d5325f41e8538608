#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <vector>

#include "model/count/config.h"
#include "model/count/counters.h"
#include "model/datapath/formats.h"
#include "model/units/frame_depth.h"
#include "model/units/primitive_setup.h"
#include "model/units/tile_cover.h"

namespace wedgesim::model::units {

/// The passes of a frame. Single-pass has one; three-pass goes through the other three.
enum class Pass : std::uint8_t { single, umbra_near, umbra_far, penumbra };

/// What a tile's visits ask of one 8x8 block.
struct BlockWork {
  std::uint16_t bx = 0, by = 0;
  std::uint64_t reads = 0;         // z, for the faces: P
  std::uint64_t umbra_reads = 0;   // z, for the umbra polygon: Q
  std::uint64_t writes = 0;        // LI, penumbra
  std::uint64_t umbra_writes = 0;  // LI, or the stencil in three-pass

  /// Pixels that penumbra takes in: each once if shared, else once for each polygon.
  unsigned pixels(bool shared) const;
};

/// One primitive in one tile. There are many: kept small.
struct TileWork {
  std::uint32_t steps = 0;        // of the tile walk since the tile before, this one included
  std::uint32_t tile = 0;         // index, row by row
  std::uint32_t first_block = 0;  // of the primitive's blocks that read or write
  std::uint32_t pixels = 0;       // that penumbra takes in
  std::uint16_t blocks = 0;       // how many
  std::uint8_t visits = 0;
  std::uint8_t words = 0;  // of {zmin, zmax} that the visits' tests name
  bool shared = false;
};

/// What the block's units compute, tile after tile, without time: which visits survive, which
/// pixels are read and written, and the words of LI and stencil. Counts accesses as the block makes
/// them.
class TileDatapath {
 public:
  /// \param trace  outlives this
  TileDatapath(const traces::TraceView& trace, const CountConfig& config, bool z_fail,
               const datapath::Formats& formats);

  /// A primitive enters, before its tiles.
  void begin(const SetupPrimitive& primitive, Pass pass);
  /// The next row of its tiles. \return tiles around those that the tile walk may step over
  TileSpan begin_row(int ty);
  /// Does a polygon that takes part in the pass touch that tile of the row?
  bool touches(int tx) const;
  /// One tile of the row that is touched. False if none of its pixels is covered; `work` is void
  /// then.
  /// \param blocks  of the primitive, to which the tile's are added
  bool process(int tx, TileWork& work, std::vector<BlockWork>& blocks);
  /// The primitive's tiles are done.
  void end();
  /// Three-pass, between the umbra passes and the penumbra: adds the stencil to LI.
  /// \return whether the 8x8 block holds a word that is not 0
  bool merge(int bx, int by);
  /// All passes are done: sums what the whole frame says.
  void finish();

  const FrameDepth& depth() const { return depth_; }
  const Counters& counters() const { return counters_; }
  /// (height, width) words, wrapped as the buffer holds them.
  const std::vector<std::int64_t>& li() const { return li_; }
  bool z_fail() const { return z_fail_; }
  /// x, y of the first pixel, by rows, whose true LI or stencil sum is out of range.
  const std::optional<std::array<int, 2>>& first_overflow() const { return first_overflow_; }

 private:
  struct Tests {
    std::uint64_t survivors = 0;  // faces
    bool untested = false;        // the box is inside the wedge
    bool reads_umbra = false, accepts_umbra = false;
    bool any() const { return survivors != 0 || reads_umbra || accepts_umbra; }
  };
  /// Pixels of an 8x8 block to which something happened at least once.
  struct BlockSets {
    std::uint64_t z_read = 0, li_written = 0, inside = 0;
  };
  bool faces_active() const { return pass_ == Pass::single || pass_ == Pass::penumbra; }
  bool umbra_active() const { return primitive_->umbra && pass_ != Pass::penumbra; }
  // The penumbra pass needs it for the sign of a coverage.
  bool needs_umbra() const { return primitive_->umbra && (umbra_active() || primitive_->coverage); }
  bool shared() const;
  void cover(int tx);
  void count_visits(TileWork& work);
  Tests test(const datapath::FixedBox& box);
  BlockWork work_on_part(std::size_t part, const Tests& tests, bool shared);
  bool inside(const datapath::Place& at) const;
  bool inner(const datapath::Place& at, bool covered) const;
  void write(int x, int y, std::int64_t li_words, int step);

  const traces::TraceView& trace_;
  const CountConfig config_;
  const bool z_fail_;
  const datapath::Formats formats_;
  const datapath::Rounder round_;
  FrameDepth depth_;
  Counters counters_;
  std::vector<std::int64_t> li_;
  std::vector<std::int32_t> stencil_;
  std::vector<std::int64_t> true_li_;       // sums that do not wrap, to know an overflow
  std::vector<std::int32_t> true_stencil_;  // the same
  std::vector<BlockSets> blocks_;
  std::vector<std::uint32_t> contributions_;
  std::optional<std::array<int, 2>> first_overflow_;
  std::vector<bool> tiles_read_;
  std::vector<bool> covering_wedges_;  // a face or the umbra polygon covers a pixel, in any pass
  const SetupPrimitive* primitive_ = nullptr;
  Pass pass_ = Pass::single;
  bool covered_any_ = false;
  int ty_ = 0;                        // the row at hand
  std::vector<TileSpan> face_spans_;  // of each face, empty where it takes no part; its touched
  TileSpan umbra_span_;               // tiles of the row, and the umbra polygon's
  // Of the tile at hand: parts, and the sets of each face and of the umbra polygon in each.
  std::vector<BlockPart> parts_;
  std::vector<std::uint64_t> face_sets_, umbra_sets_;  // (parts, faces), (parts)
};

}  // namespace wedgesim::model::units
