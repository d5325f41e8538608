#pragma once

#include <cstdint>
#include <vector>

#include "model/count/operands.h"
#include "model/count/primitive.h"
#include "traces/trace.h"

namespace wedgesim::reports::stress {

/// What one datapath makes of a frame: every wedge and umbra polygon at every pixel, without tiles,
/// blocks or kernels. A second way to the words of model::count.
struct Evaluation {
  std::vector<std::int64_t> sums;  // (height, width) words, fully lit included; not wrapped
  std::vector<std::uint32_t> contributions;  // (height, width) of wedges, to the pixels inside them
  std::uint64_t signs = 0;  // tests of planes, wedges' and umbra polygons', at what they cover
  std::uint64_t wrong_signs = 0;  // those that the trace's plane, exactly, denies
  std::uint64_t not_finite = 0;   // contributions that are no number; they add nothing
  std::uint64_t saturated = 0;    // contributions outside [0, 1], by more than rounding
  std::uint64_t visits = 0;       // pixels inside wedges: contributions evaluated
  double seconds = 0.0;           // of one thread, for `visits` contributions alone
  /// What one primitive does at one pixel, units of full light.
  struct Share {
    std::size_t pixel = 0;
    double li = 0.0;
    bool operator==(const Share&) const = default;
  };
  struct Part {
    std::uint32_t number = 0;   // of the primitive, as in wedges_at
    std::vector<Share> shares;  // by pixel; not where it does nothing
  };
  std::vector<Part> parts;  // of all primitives, the wedges first
};

Evaluation evaluate(const traces::TraceView& trace, model::ZMethod method,
                    const model::Datapath& datapath);

/// The primitives that each of some pixels belongs to: a face or the umbra polygon covers it. A
/// wedge is its index in the trace, a lone umbra polygon its own plus the number of wedges.
/// \param pixels  indices into the frame, row-major
std::vector<std::vector<std::uint32_t>> wedges_at(const traces::TraceView& trace,
                                                  const std::vector<std::size_t>& pixels);

}  // namespace wedgesim::reports::stress
