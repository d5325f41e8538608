#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <span>
#include <vector>

#include "model/count/footprint.h"

namespace wedgesim::model {

/// The pixels of a tile that lie in one block of a footprint.
struct TilePart {
  std::size_t block = 0;   // of the footprint
  std::uint64_t bits = 0;  // all the tile's pixels there
};

/// Calls f(tx, ty, parts) for every tile of a size in which a footprint covers a pixel.
/// \param parts  scratch memory
template <typename F>
void for_each_tile(const Footprint& footprint, unsigned tile, std::vector<TilePart>& parts, F&& f) {
  const auto covered = [&](std::size_t block) {
    return footprint.outline(block) | footprint.umbra(block);
  };
  if (tile < kBlock) {
    const unsigned per_block = kBlock / tile;
    const std::uint64_t corner = tile == 2 ? 0x303U : 0x0f0f0f0fU;
    for (std::size_t i = 0; i < footprint.blocks().size(); ++i) {
      const Block& block = footprint.blocks()[i];
      for (unsigned k = 0; k < per_block * per_block; ++k) {
        const unsigned tx = k % per_block;
        const unsigned ty = k / per_block;
        const std::uint64_t bits = corner << (tile * (kBlock * ty + tx));
        if ((covered(i) & bits) == 0) continue;
        parts.assign(1, {i, bits});
        f(block.bx * per_block + tx, block.by * per_block + ty, std::span<const TilePart>(parts));
      }
    }
    return;
  }
  const std::uint32_t blocks = tile / kBlock;  // along a tile's edge
  std::array<std::size_t, Footprint::kRows> next{};
  for (int first = 0; first < Footprint::kRows; first += static_cast<int>(blocks)) {
    const int last = first + static_cast<int>(blocks);
    if (footprint.row_begin(first) == footprint.row_begin(last)) continue;
    for (int row = first; row < last; ++row) {
      next[static_cast<std::size_t>(row)] = footprint.row_begin(row);
    }
    for (;;) {
      // The leftmost tile not yet walked, then its blocks in all rows.
      std::uint32_t tx = UINT32_MAX;
      std::uint32_t ty = 0;
      for (int row = first; row < last; ++row) {
        const std::size_t i = next[static_cast<std::size_t>(row)];
        if (i == footprint.row_begin(row + 1)) continue;
        tx = std::min(tx, footprint.blocks()[i].bx / blocks);
        ty = footprint.blocks()[i].by / blocks;
      }
      if (tx == UINT32_MAX) break;
      parts.clear();
      for (int row = first; row < last; ++row) {
        std::size_t& i = next[static_cast<std::size_t>(row)];
        while (i < footprint.row_begin(row + 1) && footprint.blocks()[i].bx / blocks == tx) {
          parts.push_back({i++, ~std::uint64_t{0}});
        }
      }
      f(tx, ty, std::span<const TilePart>(parts));
    }
  }
}

}  // namespace wedgesim::model
