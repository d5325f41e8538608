#pragma once

#include <cstdint>
#include <memory>
#include <optional>
#include <span>
#include <vector>

#include "model/count/config.h"
#include "model/count/counters.h"
#include "model/count/pixel_check.h"
#include "model/count/primitive.h"
#include "traces/trace.h"

namespace wedgesim::model {

enum class KernelChoice { simd, scalar };

struct CountOptions {
  unsigned threads = 0;  // 0: all cores
  bool maps = false;     // keep the per-pixel maps and the LI words
  Datapath datapath;
  KernelChoice kernel = KernelChoice::simd;  // every kernel gives the same bits
};

/// What one configuration does with a trace.
struct CountResult {
  CountConfig config;
  ZMethod z = ZMethod::pass;  // config.z, resolved
  std::unique_ptr<Counters> counters;
  PixelCheck pixels;
  /// Contributions that a wrong culling, acceptance or skipped test lost or gained: 0 in a right
  /// block.
  std::uint64_t wrong_contributions = 0;
  /// Pairs of a penumbra face, or of an umbra polygon that is no cap, with a tile in which it
  /// covers pixels but writes none: what a perfect culling would skip, whatever this one does.
  std::uint64_t needless_visits = 0;
  /// Of z_reads those that penumbra faces ask for, |P|; in a shared visit the umbra polygon may ask
  /// for the same.
  std::uint64_t penumbra_z_reads = 0;
  std::optional<std::array<int, 2>> first_overflow;  // x, y of the first of li_overflow_pixels
  // Maps, (height, width); empty unless asked for.
  std::vector<std::uint32_t> z_reads;
  std::vector<std::uint32_t> li_writes;
  std::vector<std::int64_t> li;  // words: 1.0 is Datapath::one()
  /// Run time of the traversal, shared by all configurations that it served.
  double seconds = 0.0;
};

/// The z method of a configuration: `automatic` takes z-fail where the trace needs it.
/// \throws InputError if z-pass is asked for where the trace needs z-fail
ZMethod resolve_z(const traces::TraceView& trace, ZChoice choice);

/// Walks a trace once for each z method, counts the accesses of every configuration, evaluates LI
/// from the trace alone and compares it with the trace's expected LI.
/// \param trace    sound: traces::verify passes
/// \return         one result a configuration, in their order; the same whatever the thread count,
///                 `seconds` apart
/// \throws         InputError if a configuration is out of range, or asks for z-pass where the
///                 trace needs z-fail, or if a pixel takes more than kMostContributions of one kind
/// Memory: the frame's buffers (24 bytes a pixel, 24 more for maps) and 1/4 byte a pixel and
/// configuration; many configurations on a large frame are walked in batches.
std::vector<CountResult> count(const traces::TraceView& trace, std::span<const CountConfig> configs,
                               const CountOptions& options = {});

}  // namespace wedgesim::model
