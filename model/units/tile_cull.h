#pragma once

#include "model/units/block_unit.h"
#include "model/units/line_reader.h"

namespace wedgesim::model::units {

struct TileCullConfig {
  memory::CacheConfig cache{2048, 64, 4};  // of {zmin, zmax}
  int outstanding = 8;                     // lines under way, 1 to 256
  LinkConfig out;
};

/// Tests a tile's box for each of its visits; values by model/units/tile_decision.h. What survives
/// goes on, with the words of the tile if a test named one.
///
/// Rate    one visit a cycle; the tile's words are looked up as the first begins.
/// Stall   while `out` is full or `outstanding` lines are under way.
/// Source  Paper II, section 3.
class TileCull final : public PipelineUnit {
 public:
  TileCull(sc_core::sc_module_name name, Timing timing, const TileCullConfig& config,
           MemoryPort& port, const memory::Layout& layout, unsigned tiles_across, Link<Token>& in,
           Link<Token>& out)
      : PipelineUnit(name, timing, in, out),
        reader_(port, config.cache, config.outstanding, "tile_cull"),
        layout_(layout),
        tiles_across_(tiles_across) {}

  const memory::Cache& cache() const { return reader_.cache(); }

 private:
  void work(const Token& token) override {
    const TileWork& tile = token.work();
    Cycle ready = 0;
    if (tile.words > 0) {
      const std::uint64_t address = layout_.address(
          memory::Surface::tile_depths, tile.tile % tiles_across_, tile.tile / tiles_across_);
      ready = reader_.read(time_,
                           {memory::Surface::tile_depths, memory::Cause::fill, token.wedge(),
                            static_cast<std::int64_t>(tile.tile)},
                           address & ~std::uint64_t{memory::kLineBytes - 1});
    }
    time_.work(tile.visits);
    visits_ += tile.visits;
    if (tile.blocks == 0) {
      culled_ += 1;
      return;
    }
    out_.push(time_, token, ready);
  }

  LineReader reader_;
  const memory::Layout& layout_;
  unsigned tiles_across_;
  Counter visits_{statistics_, "visits", Unit::visits, "Visits tested"};
  Counter culled_{statistics_, "tiles_culled", Unit::tiles, "Tiles of which nothing goes on"};
};

}  // namespace wedgesim::model::units
