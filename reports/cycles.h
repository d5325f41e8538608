#pragma once

#include <string>

#include "model/block/block.h"
#include "model/count/pixel_check.h"
#include "reports/json.h"

namespace wedgesim::reports {

/// A frame in time, and what it is compared with.
struct CyclesReport {
  TraceInfo trace;
  model::BlockConfig config;
  bool z_fail = false;
  std::shared_ptr<const model::units::FrameWalk> frame;
  model::BlockResult result;
  model::PixelCheck pixels;
  std::uint64_t datapath_bytes = 0;  // counted words at their widths: what no cache saves
  double value_seconds = 0.0;        // to compute the values
  double seconds = 0.0;              // to run the units over them

  const model::Counters& counters() const { return frame->datapath().counters(); }
};

/// Runs a frame of a trace through a block and compares its LI words with the expected LI.
/// \param trace  sound
CyclesReport run_cycles(const traces::TraceView& trace, const model::BlockConfig& config,
                        const model::BlockOptions& options);

/// Every pixel is within its tolerance.
bool held(const CyclesReport& report);

/// Schema wedgesim.cycles/1.
Json cycles_json(const CyclesReport& report);

/// Cycles, the bottleneck, units, hit rates and bytes at the three levels.
std::string cycles_text(const CyclesReport& report);

}  // namespace wedgesim::reports
