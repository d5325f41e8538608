#pragma once

#include "model/units/block_unit.h"

namespace wedgesim::model::units {

struct PenumbraConfig {
  int lanes = 4;          // pixels a cycle: 1, 2, 4, 8, 16
  LinkConfig out{8, 24};  // its latency is the depth of the pipeline
};

/// Decides which pixels are inside the wedge and hit by the umbra polygon, and computes light
/// intensity or coverage; values by model/datapath.
///
/// Rate    `lanes` pixels a cycle: those whose z was read, and those of an accepted umbra polygon
///         or cap, which pass through unread; a pixel of a face and an unshared umbra polygon
///         counts twice.
/// Latency out.latency_cycles.
/// Stall   while `out` is full.
/// Source  Paper II, section 3; Papers III and IV for coverage.
class Penumbra final : public OnDemandUnit {
 public:
  Penumbra(sc_core::sc_module_name name, Timing timing, const PenumbraConfig& config,
           Link<Token>& in, Link<Token>& out)
      : OnDemandUnit(name, timing, in, out), lanes_(static_cast<unsigned>(config.lanes)) {}

 private:
  bool begin(Token& token) override {
    const unsigned pixels = token.work().pixels;
    time_.work((pixels + lanes_ - 1) / lanes_);
    pixels_ += pixels;
    return true;
  }

  const unsigned lanes_;
  Counter pixels_{statistics_, "pixels", Unit::pixels, "Pixels taken in"};
};

}  // namespace wedgesim::model::units
