#pragma once

#include "model/units/block_unit.h"
#include "model/units/line_reader.h"

namespace wedgesim::model::units {

struct ZReadConfig {
  memory::CacheConfig cache{8192, 64, 4};
  int outstanding = 16;  // lines under way, 1 to 256
  LinkConfig out;
};

/// Reads the depth words of a tile's surviving pixels, line by line. Tags are looked up as tiles
/// come, so misses overlap; a tile goes on when its last line is there.
///
/// Rate    one line a cycle; a tile that reads no depth takes one cycle.
/// Stall   while `out` is full or `outstanding` lines are under way.
/// Source  Paper II, section 3.
class ZRead final : public PipelineUnit {
 public:
  ZRead(sc_core::sc_module_name name, Timing timing, const ZReadConfig& config, MemoryPort& port,
        const memory::Layout& layout, Link<Token>& in, Link<Token>& out)
      : PipelineUnit(name, timing, in, out),
        reader_(port, config.cache, config.outstanding, "z_read"),
        layout_(layout) {}

  const memory::Cache& cache() const { return reader_.cache(); }

 private:
  void work(const Token& token) override {
    const TileWork& tile = token.work();
    const AccessTag tag{memory::Surface::z, memory::Cause::fill, token.wedge(),
                        static_cast<std::int64_t>(tile.tile)};
    Cycle ready = 0;
    bool reads = false;
    for (const BlockWork& block : token.blocks()) {
      const std::uint64_t set = block.reads | block.umbra_reads;
      if (set == 0) continue;
      reads = true;
      for (const std::uint64_t line : layout_.lines(memory::Surface::z, block.bx, block.by, set)) {
        time_.work(1);
        ready = std::max(ready, reader_.read(time_, tag, line));
        lines_ += 1;
      }
    }
    if (!reads) time_.work(1);
    out_.push(time_, token, ready);
  }

  LineReader reader_;
  const memory::Layout& layout_;
  Counter lines_{statistics_, "lines", Unit::accesses, "Lines of depth looked up"};
};

}  // namespace wedgesim::model::units
