#pragma once

#include "model/units/block_unit.h"

namespace wedgesim::model::units {

struct WedgeSetupConfig {
  int cycles_a_plane = 1;  // 0 to 64
  int cycles_an_edge = 1;  // 0 to 64
  LinkConfig out;
};

/// Prepares a primitive's planes and edge functions; values by model/units/primitive_setup.h.
///
/// Rate    cycles_a_plane for each plane and cycles_an_edge for each edge of a polygon that takes
///         part in the pass, at least one cycle.
/// Stall   while `out` is full.
/// Source  Paper II, section 3.
class WedgeSetup final : public OnDemandUnit {
 public:
  WedgeSetup(sc_core::sc_module_name name, Timing timing, const WedgeSetupConfig& config,
             Link<Token>& in, Link<Token>& out)
      : OnDemandUnit(name, timing, in, out), config_(config) {}

 private:
  bool begin(Token& token) override {
    const Cycle cycles =
        Cycle{token.primitive->planes} * static_cast<Cycle>(config_.cycles_a_plane) +
        Cycle{token.primitive->edges} * static_cast<Cycle>(config_.cycles_an_edge);
    time_.work(std::max<Cycle>(cycles, 1));
    primitives_ += 1;
    return true;
  }

  const WedgeSetupConfig config_;
  Counter primitives_{statistics_, "primitives", Unit::wedges, "Primitives prepared"};
};

}  // namespace wedgesim::model::units
