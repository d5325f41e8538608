#pragma once

#include <functional>

#include "model/units/block_unit.h"
#include "model/units/line_reader.h"

namespace wedgesim::model::units {

struct WedgeFetchConfig {
  int outstanding = 32;  // lines under way, 1 to 256
  LinkConfig out;
};

/// Fetches the records of wedges, in order, each line once; a polygon without a record takes one
/// cycle. Before a pass that needs an empty block it waits until the LI update has drained.
///
/// Rate    one line a cycle; a record that ends in the line before takes one cycle, too.
/// Stall   while `out` is full or `outstanding` lines are under way.
/// Source  Paper II, section 3.
class WedgeFetch final : public BlockUnit {
 public:
  using Source = std::function<const PrimitiveWork*()>;  // null at the end

  WedgeFetch(sc_core::sc_module_name name, Timing timing, const WedgeFetchConfig& config,
             Source source, MemoryPort& port, const memory::Layout& layout, Link<Token>& out);

  /// The last unit is empty as of a cycle, that path its account.
  void drained(Cycle cycle, const CriticalPath& path = {});

 private:
  void process() override;
  Cycle fetch(const PrimitiveWork& primitive);
  void wait_until_drained();

  Source source_;
  MemoryPort& port_;
  const memory::Layout& layout_;
  Link<Token>& out_;
  Outstanding outstanding_;
  std::uint64_t last_line_ = ~std::uint64_t{0};
  Cycle last_ready_ = 0;
  bool is_drained_ = false;
  Cycle drained_at_ = 0;
  CriticalPath drained_path_;
  sc_core::sc_event drained_event_;
  Counter lines_{statistics_, "lines", Unit::accesses, "Lines of wedge records fetched"};
};

}  // namespace wedgesim::model::units
