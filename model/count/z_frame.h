#pragma once

#include <cstddef>
#include <cstdint>
#include <vector>

#include "model/count/operands.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// A block is 8x8 pixels; a set of its pixels is one 64-bit word, bit 8*row + column.
inline constexpr int kBlock = 8;
inline constexpr int kBlockPixels = kBlock * kBlock;

/// The stored depth of a frame, decoded, in block order: every buffer of the counter is indexed by
/// block * kBlockPixels + bit. Pixels that only pad the frame to whole blocks have depth 1.
class ZFrame {
 public:
  explicit ZFrame(const Operands& operands);

  int width() const { return width_; }
  int height() const { return height_; }
  std::size_t block_count() const { return std::size_t{blocks_x_} * blocks_y_; }
  std::size_t block(std::uint32_t bx, std::uint32_t by) const {
    return std::size_t{by} * blocks_x_ + bx;
  }
  /// Calls f(bx, by) for every block, row by row.
  template <typename F>
  void for_each_block(F&& f) const {
    for (std::uint32_t by = 0; by < blocks_y_; ++by) {
      for (std::uint32_t bx = 0; bx < blocks_x_; ++bx) f(bx, by);
    }
  }
  std::size_t position(int x, int y) const {
    return block(static_cast<std::uint32_t>(x) / kBlock, static_cast<std::uint32_t>(y) / kBlock) *
               kBlockPixels +
           static_cast<std::size_t>((y % kBlock) * kBlock + x % kBlock);
  }
  /// The 64 depths of a block.
  const double* z_of(std::size_t block) const { return z_.data() + block * kBlockPixels; }
  /// The interval of a block's depths.
  ZInterval interval_of(std::size_t block) const { return intervals_[block]; }
  double z(int x, int y) const { return z_[position(x, y)]; }

 private:
  int width_, height_;
  std::uint32_t blocks_x_, blocks_y_;
  std::vector<double> z_;
  std::vector<ZInterval> intervals_;
};

/// Pixels in a tile's box.
inline std::uint64_t pixels_in(const Box& box) {
  return static_cast<std::uint64_t>((box.x1 - box.x0) * (box.y1 - box.y0));
}

/// zmin and zmax of every tile of one size, sky pixels included.
class TileDepths {
 public:
  TileDepths(const ZFrame& frame, unsigned tile);

  unsigned tile() const { return tile_; }
  std::size_t count() const { return intervals_.size(); }
  std::size_t index(std::uint32_t tx, std::uint32_t ty) const {
    return std::size_t{ty} * tiles_x_ + tx;
  }
  /// Full pixel edges clipped to the frame, and the interval of the stored depths.
  Box box(std::uint32_t tx, std::uint32_t ty) const;
  /// Pixels of the frame in a tile.
  std::uint64_t pixels(std::size_t index) const {
    return pixels_in(box(static_cast<std::uint32_t>(index % tiles_x_),
                         static_cast<std::uint32_t>(index / tiles_x_)));
  }

 private:
  int width_, height_;
  unsigned tile_;
  std::uint32_t tiles_x_, tiles_y_;
  std::vector<ZInterval> intervals_;
};

}  // namespace wedgesim::model
