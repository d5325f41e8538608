#pragma once

#include <cstdint>
#include <vector>

#include "model/count/primitive.h"
#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// What the trace's own numbers, in double precision, may have lost of a primitive at the frame's
/// pixels: every datapath lacks it.
struct TraceRounding {
  std::uint32_t number = 0;  // of the primitive, as in wedges_at (evaluate.h)
  /// At a pixel a plane that LI jumps across is nearer to 0 than its rounding explains.
  bool uncertain = false;
  /// The most that rounding of its edge (light_rounding.h), or of its planes if it is `linear`
  /// (linear_rounding.h), may move at a pixel inside its faces and its depths; units of full light.
  double moved = 0.0;
};

/// Of all primitives, the wedges first.
std::vector<TraceRounding> trace_roundings(const traces::TraceView& trace, model::ZMethod method);

}  // namespace wedgesim::reports::stress
