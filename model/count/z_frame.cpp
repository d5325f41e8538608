#include "model/count/z_frame.h"

#include <tbb/parallel_for.h>

#include <algorithm>
#include <limits>

#include "base/check.h"

namespace wedgesim::model {
namespace {

std::uint32_t ceil_div(std::uint32_t a, std::uint32_t b) { return (a + b - 1) / b; }

}  // namespace

ZFrame::ZFrame(const Operands& operands)
    : width_(static_cast<int>(operands.trace().header.width)),
      height_(static_cast<int>(operands.trace().header.height)),
      blocks_x_(ceil_div(operands.trace().header.width, kBlock)),
      blocks_y_(ceil_div(operands.trace().header.height, kBlock)),
      z_(block_count() * kBlockPixels, operands.far()),
      intervals_(block_count()) {
  const traces::TraceView& trace = operands.trace();
  CHECK_EQ(trace.depth.size(), std::size_t{trace.header.width} * trace.header.height);
  tbb::parallel_for(0, height_, [&](int y) {
    const std::size_t row = static_cast<std::size_t>(y) * trace.header.width;
    for (int x = 0; x < width_; ++x) {
      z_[position(x, y)] = operands.depth(trace.depth[row + static_cast<std::size_t>(x)]);
    }
  });
  tbb::parallel_for(std::size_t{0}, block_count(), [&](std::size_t block) {
    const auto [low, high] = std::minmax_element(z_of(block), z_of(block) + kBlockPixels);
    intervals_[block] = {*low, *high};
  });
}

TileDepths::TileDepths(const ZFrame& frame, unsigned tile)
    : width_(frame.width()),
      height_(frame.height()),
      tile_(tile),
      tiles_x_(ceil_div(static_cast<std::uint32_t>(width_), tile)),
      tiles_y_(ceil_div(static_cast<std::uint32_t>(height_), tile)),
      intervals_(std::size_t{tiles_x_} * tiles_y_) {
  tbb::parallel_for(std::uint32_t{0}, tiles_y_, [&](std::uint32_t ty) {
    for (std::uint32_t tx = 0; tx < tiles_x_; ++tx) {
      const Box edges = box(tx, ty);
      ZInterval z{std::numeric_limits<double>::infinity(), 0.0};
      for (int y = static_cast<int>(edges.y0); y < static_cast<int>(edges.y1); ++y) {
        for (int x = static_cast<int>(edges.x0); x < static_cast<int>(edges.x1); ++x) {
          z.min = std::min(z.min, frame.z(x, y));
          z.max = std::max(z.max, frame.z(x, y));
        }
      }
      intervals_[index(tx, ty)] = z;
    }
  });
}

Box TileDepths::box(std::uint32_t tx, std::uint32_t ty) const {
  const auto edge = [this](std::uint32_t t, int limit) {
    return static_cast<double>(std::min<std::int64_t>(std::int64_t{t} * tile_, limit));
  };
  return {edge(tx, width_), edge(tx + 1, width_), edge(ty, height_), edge(ty + 1, height_),
          intervals_[index(tx, ty)]};
}

}  // namespace wedgesim::model
