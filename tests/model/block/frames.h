#pragma once

#include <memory>
#include <string>
#include <utility>
#include <vector>

#include "model/block/block.h"
#include "tests/support/render.h"

namespace wedgesim::model::test {

/// A small frame of a built-in scene.
inline traces::Trace render(const std::string& scene, traces::fb::WedgeKind kind,
                            std::pair<int, int> size = {96, 64}) {
  return wedgesim::test::render(scene, kind, size);
}

/// A frame of 16x16 pixels in tiles of 8 that does what a test says, without a trace.
inline RecordedFrame frame_of(const std::vector<units::PrimitiveWork>& works) {
  RecordedFrame frame;
  frame.layout.width = 16;
  frame.layout.height = 16;
  for (const units::PrimitiveWork& work : works) {
    frame.work.push_back(std::make_shared<units::PrimitiveWork>(work));
    frame.layout.wedge_bytes += work.record_bytes;
  }
  return frame;
}

/// Every queue of a block.
inline std::vector<units::LinkConfig*> queues(BlockConfig& config) {
  return {&config.wedge_fetch.out, &config.wedge_setup.out, &config.tile_walk.out,
          &config.tile_cull.out,   &config.z_read.out,      &config.penumbra.out};
}

/// Every cache of a block.
inline std::vector<memory::CacheConfig*> caches(BlockConfig& config) {
  return {&config.tile_cull.cache, &config.z_read.cache, &config.li_update.cache,
          &config.li_update.stencil_cache};
}

}  // namespace wedgesim::model::test
