#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/units/tile_work.h"

namespace wedgesim::model::units {

/// A block whose stencil is added to LI.
struct MergedBlock {
  std::uint16_t bx = 0, by = 0;
  bool any = false;  // a word is not 0
};

/// One primitive in one pass, or the merge: all that the units need to know to take time over it.
struct PrimitiveWork {
  std::optional<std::uint32_t> wedge;
  std::uint64_t record_offset = 0, record_bytes = 0;
  unsigned planes = 0, edges = 0;  // what setup prepares
  bool barrier = false;            // the units must be empty before it
  std::vector<TileWork> tiles;
  std::vector<BlockWork> blocks;  // of its tiles, one tile's after the other's
  unsigned steps_after = 0;       // of the tile walk behind the last tile
  std::vector<MergedBlock> merged;

  std::span<const BlockWork> blocks_of(const TileWork& tile) const {
    return {blocks.data() + tile.first_block, tile.blocks};
  }
};

/// Walks the frame pass by pass, primitive by primitive, in the order of the trace; in each, tiles
/// row by row, as the block does.
class FrameWalk {
 public:
  /// \param trace  sound, outlives this
  FrameWalk(const traces::TraceView& trace, const CountConfig& config, bool z_fail,
            const datapath::Formats& formats);

  /// The next primitive or merge; nothing at the end of the frame.
  std::shared_ptr<const PrimitiveWork> next();

  /// Bytes of the records of all wedges.
  std::uint64_t record_bytes() const { return record_offsets_.back(); }

  /// What was counted and computed so far; whole after the last.
  const TileDatapath& datapath() const { return datapath_; }

 private:
  std::shared_ptr<PrimitiveWork> walk(const SetupPrimitive& primitive, Pass pass);
  std::shared_ptr<PrimitiveWork> merge();

  const traces::TraceView& trace_;
  PrimitiveSetup setup_;
  TileDatapath datapath_;
  std::vector<std::uint32_t> lone_;
  std::vector<std::uint64_t> record_offsets_;  // of each wedge, and their end
  std::vector<Pass> passes_;
  std::size_t pass_ = 0;
  std::size_t index_ = 0;        // in the pass: wedges, then lone polygons
  std::vector<TileWork> tiles_;  // of the primitive at hand: their room is used again
  std::vector<BlockWork> blocks_;
  bool barrier_ = false;
  bool finished_ = false;
};

}  // namespace wedgesim::model::units
