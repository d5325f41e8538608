#pragma once

#include <algorithm>
#include <cstdint>
#include <vector>

#include "model/datapath/form.h"
#include "model/units/primitive_setup.h"
#include "traces/trace.h"

namespace wedgesim::model::units {

/// The z-buffer in steps, and the tiles' zmin and zmax.
class FrameDepth {
 public:
  FrameDepth(const traces::TraceView& trace, int tile)
      : width_(static_cast<int>(trace.header.width)),
        height_(static_cast<int>(trace.header.height)),
        tile_(tile),
        tiles_x_((width_ + tile - 1) / tile),
        tiles_y_((height_ + tile - 1) / tile),
        tiles_(static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_)) {
    const datapath::ZSteps steps(trace.header.depth_format, trace.depth);
    z_.resize(trace.depth.size());
    std::transform(
        trace.depth.begin(), trace.depth.end(), z_.begin(),
        [&steps](std::uint32_t word) { return static_cast<std::int32_t>(steps.of_word(word)); });
    for (int ty = 0; ty < tiles_y_; ++ty) {
      for (int tx = 0; tx < tiles_x_; ++tx) {
        const PixelBox p = pixels(tx, ty);
        std::int32_t low = INT32_MAX;
        std::int32_t high = INT32_MIN;
        for (int y = p.y0; y < p.y1; ++y) {
          for (int x = p.x0; x < p.x1; ++x) {
            low = std::min(low, z_[index(x, y)]);
            high = std::max(high, z_[index(x, y)]);
          }
        }
        tiles_[tile_index(tx, ty)] = {low, high};
      }
    }
  }

  int width() const { return width_; }
  int height() const { return height_; }
  int tile() const { return tile_; }
  std::size_t tile_count() const { return tiles_.size(); }
  std::size_t tile_index(int tx, int ty) const {
    return static_cast<std::size_t>(ty) * static_cast<std::size_t>(tiles_x_) +
           static_cast<std::size_t>(tx);
  }
  std::size_t index(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(width_) +
           static_cast<std::size_t>(x);
  }
  /// Of the 8x8 blocks, row by row.
  std::size_t block_count() const { return block_index(0, (height_ + 7) / 8); }
  std::size_t block_index(int bx, int by) const {
    return static_cast<std::size_t>(by) * static_cast<std::size_t>((width_ + 7) / 8) +
           static_cast<std::size_t>(bx);
  }
  std::int64_t z(int x, int y) const { return z_[index(x, y)]; }
  /// A tile's pixels in the frame.
  PixelBox pixels(int tx, int ty) const {
    return {tx * tile_, ty * tile_, std::min((tx + 1) * tile_, width_),
            std::min((ty + 1) * tile_, height_)};
  }
  /// The pixels of a row of tiles.
  PixelBox row(int ty) const {
    return {0, ty * tile_, width_, std::min((ty + 1) * tile_, height_)};
  }
  /// A tile's pixel edges, clipped to the frame, and its depths, sky included.
  datapath::FixedBox box(int tx, int ty) const {
    const PixelBox p = pixels(tx, ty);
    const ZSpan& z = tiles_[tile_index(tx, ty)];
    return {{2 * p.x0, 2 * p.y0, z.min}, {2 * p.x1, 2 * p.y1, z.max}};
  }

 private:
  int width_, height_, tile_, tiles_x_, tiles_y_;
  std::vector<std::int32_t> z_;
  std::vector<ZSpan> tiles_;
};

}  // namespace wedgesim::model::units
