#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "model/block/block.h"
#include "model/count/pixel_check.h"
#include "model/memory/energy.h"
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
  std::uint64_t datapath_bytes = 0;   // counted words at their widths: what no cache saves
  std::uint64_t floor_bytes = 0;      // that every design must move: both floors of the frame
  double peak_bytes_per_cycle = 0.0;  // at the port, over PortProfile::kWindowCycles
  std::vector<std::uint64_t> tile_bytes, tile_cycles;  // (tiles down, tiles across)
  std::optional<model::memory::Energy> energy;
  double value_seconds = 0.0;  // to compute the values
  double seconds = 0.0;        // to run the units over them

  const model::Counters& counters() const { return frame->datapath().counters(); }
};

/// A frame's values and their comparison with the expected LI: the same for every block with the
/// same rasterizer and formats.
struct CheckedFrame {
  TraceInfo trace;
  model::RecordedFrame frame;
  model::PixelCheck pixels;
  double seconds = 0.0;  // to compute the values
};

/// \param trace  sound; outlives the result
/// \throws InputError as count() does
CheckedFrame check_frame(const traces::TraceView& trace, const model::BlockConfig& config);

/// Runs a frame through a block.
/// \param config  with the rasterizer and formats of the frame
/// \param energy  what accesses cost; null: unknown
CyclesReport run_cycles(const CheckedFrame& frame, const model::BlockConfig& config,
                        const model::BlockOptions& options,
                        const model::memory::EnergyTable* energy = nullptr);

/// Writes PREFIX_tile_bytes and PREFIX_tile_cycles as .png and .exr, each tile as large as its
/// pixels: bytes at the port, and cycles that culling and the penumbra datapath take.
/// \return what the brightest colours stand for, as text
/// \throws InputError if a file cannot be written
std::string write_tile_maps(const std::string& prefix, const CyclesReport& report);

/// Of the lookups of a cache, or of the bursts of a DRAM, those that found it open: 0 to 1; nothing
/// if there is no cache, no DRAM, or nothing was looked up.
std::optional<double> hit_rate(const model::CacheResult& cache);
std::optional<double> row_hit_rate(const model::BlockResult& result);

/// Bytes of the DRAM's bursts; nothing if the memory is no DRAM.
std::optional<std::uint64_t> burst_bytes(const model::BlockResult& result);

/// What the counts come to at the block's clock. GB are 10^9 bytes.
struct Rates {
  double frames_per_second = 0.0;
  double port_gb_per_second = 0.0;     // at the port, over the frame
  double busiest_gb_per_second = 0.0;  // asked for in the busiest PortProfile::kWindowCycles
  double peak_gb_per_second = 0.0;     // of the memory; 0 if it is unknown
  double port_bytes_over_floor = 0.0;  // bytes at the port for each byte that must move
};
Rates rates_of(const CyclesReport& report);

/// Every pixel is within its tolerance.
bool held(const CyclesReport& report);

/// 16 hexadecimal digits that two configurations share iff they are the same, whatever their names.
std::string hash_of(const model::BlockConfig& config);

/// Schema wedgesim.cycles/1.
Json cycles_json(const CyclesReport& report);

/// Cycles, the bottleneck, units, hit rates and bytes at the three levels.
std::string cycles_text(const CyclesReport& report);

}  // namespace wedgesim::reports
