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
class TileWalk final : public OnDemandUnit {
 public:
  TileWalk(sc_core::sc_module_name name, Timing timing, const TileWalkConfig& config,
           Link<Token>& in, Link<Token>& out)
      : OnDemandUnit(name, timing, in, out),
        cycles_a_tile_(static_cast<Cycle>(config.cycles_a_tile)) {}

 private:
  bool begin(Token& token) override {
    const PrimitiveWork& primitive = *token.primitive;
    if (primitive.tiles.empty() && primitive.steps_after == 0) time_.work(1);
    return walk_to(token);
  }
  bool proceed(Token& token) override {
    ++token.tile;
    return walk_to(token);
  }
  // To the tile of the token, or to the primitive's end.
  bool walk_to(const Token& token) {
    const PrimitiveWork& primitive = *token.primitive;
    const bool more = token.tile < primitive.tiles.size();
    const std::uint32_t tiles = more ? token.work().steps : primitive.steps_after;
    time_.work(tiles * cycles_a_tile_);
    tiles_ += tiles;
    return more;
  }

  const Cycle cycles_a_tile_;
  Counter tiles_{statistics_, "tiles", Unit::tiles, "Tiles stepped over"};
};

}  // namespace wedgesim::model::units
