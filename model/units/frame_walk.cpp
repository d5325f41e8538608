#include "model/units/frame_walk.h"

#include <algorithm>
#include <utility>

#include "traces/record.h"

namespace wedgesim::model::units {

FrameWalk::FrameWalk(const traces::TraceView& trace, const CountConfig& config, bool z_fail,
                     const datapath::Formats& formats)
    : trace_(trace),
      setup_(trace, z_fail, formats),
      datapath_(trace, config, z_fail, formats),
      lone_(setup_.lone_umbras()) {
  if (config.mode == Mode::single_pass) {
    passes_ = {Pass::single};
  } else {
    passes_ = {Pass::umbra_near, Pass::umbra_far, Pass::penumbra};
  }
  record_offsets_.push_back(0);
  for (std::uint32_t i = 0; i < trace.wedges.size(); ++i) {
    record_offsets_.push_back(record_offsets_.back() + traces::wedge_record_bytes(trace, i));
  }
}

std::shared_ptr<const PrimitiveWork> FrameWalk::next() {
  while (pass_ < passes_.size()) {
    const Pass pass = passes_[pass_];
    const std::size_t wedges = trace_.wedges.size();
    if (index_ == wedges + lone_.size()) {
      ++pass_;
      index_ = 0;
      barrier_ = true;
      if (pass == Pass::umbra_far) return merge();
      continue;
    }
    const std::size_t index = index_++;
    SetupPrimitive primitive;
    const bool is_wedge = index < wedges;
    auto umbra = is_wedge ? setup_.umbra_of_wedge(static_cast<std::uint32_t>(index))
                          : setup_.umbra(lone_[index - wedges]);
    const bool umbra_pass = pass == Pass::umbra_near || pass == Pass::umbra_far;
    // Near: the umbra polygons that face as the wedges' faces do.
    if (umbra_pass && (!umbra || umbra->hits_inner != (pass == Pass::umbra_near))) continue;
    if (!is_wedge && (!umbra || pass == Pass::penumbra)) continue;
    if (is_wedge) {
      primitive = setup_.penumbra(static_cast<std::uint32_t>(index));
      primitive.record_bytes = record_offsets_[index + 1] - record_offsets_[index];
    }
    primitive.umbra = std::move(umbra);
    auto work = walk(primitive, pass);
    if (is_wedge) {
      work->wedge = static_cast<std::uint32_t>(index);
      work->record_offset = record_offsets_[index];
    }
    return work;
  }
  if (!finished_) datapath_.finish();
  finished_ = true;
  return nullptr;
}

std::shared_ptr<PrimitiveWork> FrameWalk::walk(const SetupPrimitive& primitive, Pass pass) {
  auto work = std::make_shared<PrimitiveWork>();
  work->barrier = barrier_;
  barrier_ = false;
  work->record_bytes = primitive.record_bytes;
  const bool penumbra = pass == Pass::single || pass == Pass::penumbra;
  if (penumbra) {
    work->planes = static_cast<unsigned>(primitive.planes.size());
    for (const SetupFace& face : primitive.faces) {
      work->edges += static_cast<unsigned>(face.polygon.edges.size());
    }
  }
  if (primitive.umbra && pass != Pass::penumbra) {
    work->planes += 1;
    work->edges += static_cast<unsigned>(primitive.umbra->polygon.edges.size());
  }
  datapath_.begin(primitive, pass);
  const PixelBox bounds = primitive.bounds();
  const int tile = datapath_.depth().tile();
  TileWork tile_work;
  tiles_.clear();
  blocks_.clear();
  for (int ty = bounds.y0 / tile; !bounds.empty() && ty * tile < bounds.y1; ++ty) {
    // A walker finds a row's first touched tile by itself; it steps over the touched ones alone.
    const TileSpan row = datapath_.begin_row(ty);
    for (int tx = row.first; tx < row.end; ++tx) {
      if (!datapath_.touches(tx)) continue;
      ++tile_work.steps;
      if (!datapath_.process(tx, tile_work, blocks_)) continue;
      tiles_.push_back(tile_work);
      tile_work.steps = 0;
    }
  }
  work->steps_after = tile_work.steps;
  work->tiles = tiles_;
  work->blocks = blocks_;
  datapath_.end();
  return work;
}

std::shared_ptr<PrimitiveWork> FrameWalk::merge() {
  auto work = std::make_shared<PrimitiveWork>();
  work->barrier = true;
  const FrameDepth& depth = datapath_.depth();
  for (int by = 0; 8 * by < depth.height(); ++by) {
    for (int bx = 0; 8 * bx < depth.width(); ++bx) {
      work->merged.push_back({static_cast<std::uint16_t>(bx), static_cast<std::uint16_t>(by),
                              datapath_.merge(bx, by)});
    }
  }
  return work;
}

}  // namespace wedgesim::model::units
