#pragma once

#include <array>
#include <cstdint>
#include <functional>
#include <memory>
#include <string>
#include <string_view>
#include <vector>

#include "base/counter.h"
#include "model/block/config.h"
#include "model/count/counters.h"
#include "model/memory/memory_record.h"
#include "model/units/frame_walk.h"
#include "model/units/memory_port.h"
#include "model/units/unit_time.h"
#include "traces/trace.h"

namespace wedgesim::model {

/// The units, in the order of the pipeline; the memory port is behind them all.
inline constexpr std::array<std::string_view, 7> kBlockUnits{
    "wedge_fetch", "wedge_setup", "tile_walk", "tile_cull", "z_read", "penumbra", "li_update"};

/// The values of a frame, computed once: what every block with the same rasterizer and formats
/// does, however long it takes.
struct RecordedFrame {
  CountConfig rasterizer;
  bool z_fail = false;
  memory::LayoutConfig layout;
  std::vector<std::shared_ptr<const units::PrimitiveWork>> work;
  std::shared_ptr<const units::FrameWalk> walk;  // its counters and LI words

  const Counters& counters() const { return walk->datapath().counters(); }
  const std::vector<std::int64_t>& li() const { return walk->datapath().li(); }
};

/// \param trace  sound; outlives the result
/// \throws InputError as count() does
RecordedFrame record_frame(const traces::TraceView& trace, const BlockConfig& config);

/// A number of a result, with its meaning.
struct Statistic {
  std::string name, unit, description;
  std::uint64_t value = 0;
};

struct UnitResult {
  std::string name;
  memory::Cycle busy = 0, starved = 0, stalled = 0;  // add up to the cycles of the run
  memory::Cycle memory = 0;                          // part of stalled: waiting for memory
  std::vector<Statistic> statistics;
};

/// Cycles that the frame's end waited for a part of the block: a unit's work ("penumbra"), its
/// memory ("memory:z_read"), or the way through the queue behind it ("queue:penumbra").
struct PathShare {
  std::string name;
  memory::Cycle cycles = 0;
};

struct CacheResult {
  std::string name;
  std::uint64_t size_bytes = 0;  // 0: there is none, and every access is a miss
  std::uint64_t hits = 0, misses = 0, write_backs = 0;
};

struct TrafficResult {
  std::string surface;
  std::uint64_t reads = 0, writes = 0, read_bytes = 0, write_bytes = 0;
};

/// A frame in time.
struct BlockResult {
  memory::Cycle cycles = 0;  // from the first fetch to the last write
  std::vector<UnitResult> units;
  std::vector<CacheResult> caches;
  std::vector<TrafficResult> traffic;  // at the port: lines
  std::vector<Statistic> memory;       // of the memory's own
  double peak_bytes_per_cycle = 0.0;

  /// In the order of the pipeline; adds up to `cycles`.
  std::vector<PathShare> critical_path;
  /// The part that the frame's end waited for longest.
  const PathShare& bottleneck() const;
  std::uint64_t port_bytes() const;
};

struct BlockOptions {
  units::Timing timing = units::Timing::decoupled;
  std::function<void(const memory::MemoryRecord&)> listener;  // of every access at the port
  /// Of every state of every unit, for cycles [begin, end); a unit's own come in order.
  std::function<void(std::string_view unit, units::UnitState state, memory::Cycle begin,
                     memory::Cycle end)>
      states;
  /// Makes a TLM-2.0 target of the user's own, instead of config.memory, and binds the port's
  /// socket to it; called while SystemC elaborates. docs/block.md has an example.
  std::function<std::unique_ptr<sc_core::sc_module>(units::MemoryPort& port)> target;
  /// How long a target may keep an access before the block is given up; at least 1.
  memory::Cycle watchdog_cycles = memory::Cycle{1} << 22;
};

/// Runs a recorded frame through the units of a configuration.
/// \param config  with the rasterizer and formats that the frame was recorded with
/// \throws SimulationError if units or memory block each other: names the queues, who holds them,
///         accesses without an answer, and the cycle
BlockResult run_block(const RecordedFrame& frame, const BlockConfig& config,
                      const BlockOptions& options = {});

}  // namespace wedgesim::model
