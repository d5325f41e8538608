#pragma once

#include <deque>
#include <utility>
#include <vector>

#include "model/units/block_unit.h"

namespace wedgesim::model::units::test {

/// The first `n` pixels of an 8x8 block, row by row.
inline std::uint64_t first_pixels(int n) {
  return n == 64 ? ~std::uint64_t{0} : (std::uint64_t{1} << n) - 1;
}

/// A block of which some pixels are read and all of these are written.
inline BlockWork block_work(int bx, int by, std::uint64_t pixels) {
  return {static_cast<std::uint16_t>(bx), static_cast<std::uint16_t>(by), pixels, 0, pixels, 0};
}

/// A tile and its blocks.
struct WalkedTile {
  TileWork work;
  std::vector<BlockWork> blocks;
};

/// A tile that the walk finds with its first step; one visit, which names both depths.
inline WalkedTile walked_tile(std::uint32_t index, std::vector<BlockWork> blocks,
                              bool shared = false) {
  WalkedTile tile;
  tile.work.steps = 1;
  tile.work.tile = index;
  tile.work.visits = 1;
  tile.work.words = 2;
  tile.work.shared = shared;
  tile.work.blocks = static_cast<std::uint16_t>(blocks.size());
  for (const BlockWork& block : blocks) tile.work.pixels += block.pixels(shared);
  tile.blocks = std::move(blocks);
  return tile;
}

/// A wedge of 4 planes and 8 edges whose record is 128 bytes. Lives as long as the test program.
inline PrimitiveWork* wedge_work(std::uint32_t index, const std::vector<WalkedTile>& tiles) {
  static std::deque<PrimitiveWork> works;
  PrimitiveWork* work = &works.emplace_back();
  work->wedge = index;
  work->record_offset = 128 * std::uint64_t{index};
  work->record_bytes = 128;
  work->planes = 4;
  work->edges = 8;
  for (const WalkedTile& tile : tiles) {
    work->tiles.push_back(tile.work);
    work->tiles.back().first_block = static_cast<std::uint32_t>(work->blocks.size());
    work->blocks.insert(work->blocks.end(), tile.blocks.begin(), tile.blocks.end());
  }
  return work;
}

/// A token of the first tile of a wedge.
inline Token tile_token(std::uint32_t wedge, std::uint32_t tile, std::vector<BlockWork> blocks) {
  return {Token::Kind::work, 0, wedge_work(wedge, {walked_tile(tile, std::move(blocks))})};
}

inline Token mark(Token::Kind kind) { return {kind, 0, nullptr}; }

}  // namespace wedgesim::model::units::test
