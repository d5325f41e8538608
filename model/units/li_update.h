#pragma once

#include <functional>
#include <vector>

#include "model/units/block_unit.h"
#include "model/units/line_reader.h"

namespace wedgesim::model::units {

enum class Clear { none, write };

struct LiUpdateConfig {
  memory::CacheConfig cache{4096, 64, 4};          // of LI
  memory::CacheConfig stencil_cache{2048, 64, 4};  // of the stencil, three-pass
  int outstanding = 16;                            // fills under way, 1 to 256
  int outstanding_writes = 64;                     // lines on their way to memory, 1 to 256
  int update_cycles = 3;                           // from a word's read to its write, 1 to 64
  Clear clear = Clear::write;                      // LI and stencil, before the frame
};

/// Reads, modifies and writes the words of LI, and of the stencil in three-pass; merges the stencil
/// into LI between the passes. Values by model/units/tile_work.h.
///
/// Rate    one line a cycle; without a cache a line is read, changed and written before the next.
/// Stall   while `outstanding` fills or `outstanding_writes` writes are under way, while a line
/// that
///         is asked for again or put out is still on its way in, while a word of a line that is put
///         out is being updated, and while a pixel is being updated for an earlier wedge
///         (update_cycles): never reads or writes back a stale word.
/// Source  Paper II, section 3.
class LiUpdate final : public BlockUnit {
 public:
  LiUpdate(sc_core::sc_module_name name, Timing timing, const LiUpdateConfig& config,
           bool three_pass, MemoryPort& port, const memory::Layout& layout, Link<Token>& in);

  using Drained = std::function<void(Cycle cycle, const CriticalPath& path)>;
  /// Called when a barrier has come through, with the first cycle in which the unit is empty and
  /// what it waited for until then.
  void on_drained(Drained listener) { drained_ = std::move(listener); }

  const memory::Cache& li_cache() const { return li_.cache; }
  const memory::Cache& stencil_cache() const { return stencil_.cache; }

 private:
  /// A cache that knows for whom its lines were last written: who pays for writing them back.
  struct WriteBackCache {
    WriteBackCache(const memory::CacheConfig& config, std::string_view place);
    memory::Cache cache;
    std::vector<AccessTag> writers;  // one a slot
  };
  /// A set of pixels of one block that is being updated.
  struct Update {
    memory::Surface surface = memory::Surface::li;
    std::uint32_t block = 0;
    std::uint64_t pixels = 0;
    Cycle done = 0;
  };

  void process() override;
  void clear(memory::Surface surface);
  void work(const Token& token);
  void merge(const PrimitiveWork& primitive);
  void flush();
  void update(memory::Surface surface, const BlockWork& block, std::uint64_t pixels,
              const Token& token, std::uint32_t tile);
  void wait_for_hazard(memory::Surface surface, std::uint32_t block, std::uint64_t pixels);
  /// \return the cycle from which the line's words are there, or written
  Cycle access(const AccessTag& tag, std::uint64_t line, bool write);
  Cycle access_uncached(const AccessTag& tag, std::uint64_t line, bool write);
  Cycle fill(const AccessTag& tag, std::uint64_t line);
  /// Until nothing is under way.
  void drain();
  void send(AccessTag tag, memory::Cause cause, std::uint64_t line);

  const LiUpdateConfig config_;
  const bool three_pass_;
  MemoryPort& port_;
  const memory::Layout& layout_;
  Link<Token>& in_;
  WriteBackCache li_, stencil_;
  Outstanding outstanding_, outstanding_writes_;
  const Cycle update_cycles_;
  std::vector<Update> updates_;  // under way: few, since a line on its way in is waited for
  Drained drained_;
  Counter lines_{statistics_, "lines", Unit::accesses, "Lines of LI and stencil updated"};
  Counter hazards_{statistics_, "hazard_cycles", Unit::cycles,
                   "Cycles held up by an update of the same pixel"};
};

}  // namespace wedgesim::model::units
