#pragma once

#include "model/units/block_unit.h"

namespace wedgesim::model::units {

struct TileWalkConfig {
  int cycles_a_tile = 1;  // 1 to 64
  LinkConfig out;
};

/// Steps over the tiles that a primitive's polygons touch, row by row, and hands on those in which
/// one covers a pixel; values by model/units/tile_cover.h.
///
/// Rate    cycles_a_tile for each touched tile; a primitive that touches none takes one cycle.
/// Stall   while `out` is full.
/// Source  Paper II, section 3 (one tile a cycle).
class TileWalk final : public PipelineUnit {
 public:
  TileWalk(sc_core::sc_module_name name, Timing timing, const TileWalkConfig& config,
           Link<Token>& in, Link<Token>& out)
      : PipelineUnit(name, timing, in, out),
        cycles_a_tile_(static_cast<Cycle>(config.cycles_a_tile)) {}

 private:
  void work(const Token& token) override {
    const PrimitiveWork& primitive = *token.primitive;
    for (std::uint32_t i = 0; i < primitive.tiles.size(); ++i) {
      step(primitive.tiles[i].steps);
      out_.push(time_, {Token::Kind::work, i, token.primitive});
    }
    step(primitive.steps_after);
    if (primitive.tiles.empty() && primitive.steps_after == 0) time_.work(1);
  }
  void step(unsigned tiles) {
    time_.work(tiles * cycles_a_tile_);
    tiles_ += tiles;
  }

  const Cycle cycles_a_tile_;
  Counter tiles_{statistics_, "tiles", Unit::tiles, "Tiles stepped over"};
};

}  // namespace wedgesim::model::units
