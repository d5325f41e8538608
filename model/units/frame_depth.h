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
        tiles_(static_cast<std::size_t>(tiles_x_) * static_cast<std::size_t>(tiles_y_),
               {INT64_MAX, INT64_MIN}) {
    const datapath::ZSteps steps(trace.header.depth_format);
    z_.reserve(trace.depth.size());
    for (std::uint32_t word : trace.depth) {
      z_.push_back(static_cast<std::int32_t>(steps.of_word(word)));
    }
    for (int y = 0; y < height_; ++y) {
      for (int x = 0; x < width_; ++x) {
        ZSpan& tile_span = tiles_[tile_index(x / tile, y / tile)];
        tile_span = {std::min(tile_span.min, z(x, y)), std::max(tile_span.max, z(x, y))};
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
  std::int64_t z(int x, int y) const { return z_[index(x, y)]; }
  /// A tile's pixels in the frame.
  PixelBox pixels(int tx, int ty) const {
    return {tx * tile_, ty * tile_, std::min((tx + 1) * tile_, width_),
            std::min((ty + 1) * tile_, height_)};
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
