#include "model/count/count.h"

#include <fmt/format.h>
#include <tbb/enumerable_thread_specific.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/task_arena.h>

#include <algorithm>
#include <bit>
#include <chrono>
#include <map>
#include <optional>

#include "base/error.h"
#include "model/count/bits.h"
#include "model/count/tally.h"
#include "model/count/traffic.h"
#include "traces/record.h"

namespace wedgesim::model {
namespace {

using traces::TraceView;

/// Bytes of per-configuration buffers that one traversal may hold.
constexpr std::uint64_t kBatchBytes = std::uint64_t{512} << 20;

/// Sums of one traversal that no configuration changes.
struct CommonSums {
  std::uint64_t pixels_covered = 0;
  std::uint64_t pixels_inside = 0;
  std::uint64_t degenerate_wedges = 0;
  std::uint64_t record_bytes = 0;        // of all wedges
  std::uint64_t umbra_record_bytes = 0;  // of those whose umbra polygon takes part

  void add(const CommonSums& other) {
    pixels_covered += other.pixels_covered;
    pixels_inside += other.pixels_inside;
    degenerate_wedges += other.degenerate_wedges;
    record_bytes += other.record_bytes;
    umbra_record_bytes += other.umbra_record_bytes;
  }
};

const Kernel& kernel_of(const CountOptions& options) {
  if (options.kernel == KernelChoice::scalar) return scalar_kernel();
  switch (options.datapath.kind) {
    case DatapathKind::fixed:
      return fixed_kernel();
    case DatapathKind::float32:
      return scalar_kernel();
    default:
      return simd_kernel();
  }
}

/// What one thread works with.
struct Worker {
  Footprint footprint;
  std::vector<TileTally> tallies;  // one a tile size
  CommonSums sums;
};

/// One walk over a trace under one z method, serving some of the configurations.
class Traversal {
 public:
  Traversal(const TraceView& trace, ZMethod method, const CountOptions& options,
            std::span<const CountConfig> configs);

  void walk();
  /// Results in the order of `configs`.
  std::vector<CountResult> finish();

 private:
  struct TileSize {
    TileDepths depths;
    std::vector<ConfigRun*> runs;
    std::vector<std::size_t> configs;  // of `runs`
  };

  void count_primitive(const Primitive& primitive, Worker& worker);
  void finish_config(const TileSize& size, std::size_t run, const FrameSummary& right,
                     CountResult& result);
  std::vector<Correction> collect(const TileSize& size, std::size_t run, CountResult& result);
  std::uint64_t build_reads(const ConfigRun& run) const;
  std::vector<std::uint32_t> by_rows(std::vector<std::uint32_t> map) const;

  const TraceView& trace_;
  ZMethod method_;
  CountOptions options_;
  const Kernel& kernel_;
  std::span<const CountConfig> configs_;
  Operands operands_;
  ZFrame frame_;
  LightImage image_;
  std::vector<std::uint32_t> lone_;
  std::map<unsigned, TileSize> sizes_;
  std::vector<std::unique_ptr<ConfigRun>> runs_;
  tbb::enumerable_thread_specific<Worker> workers_;
  CommonSums sums_;
};

Traversal::Traversal(const TraceView& trace, ZMethod method, const CountOptions& options,
                     std::span<const CountConfig> configs)
    : trace_(trace),
      method_(method),
      options_(options),
      kernel_(kernel_of(options)),
      configs_(configs),
      operands_(trace, options.datapath),
      frame_(operands_),
      image_(frame_),
      lone_(lone_polygons(trace, method)),
      workers_([this] {
        Worker worker;
        for (const auto& [tile, size] : sizes_) {
          worker.tallies.emplace_back(size.runs, frame_, method_, options_.datapath.one());
        }
        return worker;
      }) {
  for (std::size_t i = 0; i < configs.size(); ++i) {
    const unsigned tile = configs[i].tile;
    auto found = sizes_.find(tile);
    if (found == sizes_.end()) {
      found = sizes_.emplace(tile, TileSize{TileDepths(frame_, tile), {}, {}}).first;
    }
    TileSize& size = found->second;
    runs_.push_back(std::make_unique<ConfigRun>(configs[i], frame_, size.depths, options.maps));
    size.runs.push_back(runs_.back().get());
    size.configs.push_back(i);
  }
}

void Traversal::walk() {
  const std::size_t wedges = trace_.wedges.size();
  tbb::parallel_for(std::size_t{0}, wedges + lone_.size(), [&](std::size_t i) {
    const Primitive primitive =
        i < wedges ? wedge_primitive(operands_, method_, static_cast<std::uint32_t>(i))
                   : lone_primitive(operands_, method_, lone_[i - wedges]);
    count_primitive(primitive, workers_.local());
  });
  for (const Worker& worker : workers_) sums_.add(worker.sums);
  frame_.for_each_block([this](std::uint32_t bx, std::uint32_t by) {
    const std::uint64_t overflowed = image_.overflowed(frame_.block(bx, by));
    if (overflowed == 0) return;
    const auto bit = static_cast<unsigned>(std::countr_zero(overflowed));
    throw InputError(
        fmt::format("trace '{}', pixel {},{}", trace_.header.name, bx * kBlock + bit % kBlock,
                    by * kBlock + bit / kBlock),
        "too many wedges or umbra polygons",
        fmt::format("at most {} contributions of one kind to a pixel", kMostContributions));
  });
}

void Traversal::count_primitive(const Primitive& primitive, Worker& worker) {
  const std::uint64_t covered_before = worker.sums.pixels_covered;
  const int bands = (frame_.height() + kBandRows - 1) / kBandRows;
  for (int band = 0; band < bands; ++band) {
    Footprint& footprint = worker.footprint;
    footprint.build(primitive, frame_, band, kernel_);
    if (footprint.blocks().empty()) continue;
    image_.add(primitive, footprint, frame_, kernel_, options_.datapath.one());
    for (std::size_t i = 0; i < footprint.blocks().size(); ++i) {
      worker.sums.pixels_covered += bit_count(footprint.outline(i)) + bit_count(footprint.umbra(i));
      worker.sums.pixels_inside += bit_count(footprint.inside(i));
    }
    for (TileTally& tally : worker.tallies) tally.count(primitive, footprint);
  }
  if (!primitive.wedge) return;
  const std::uint64_t bytes = traces::wedge_record_bytes(trace_, *primitive.wedge);
  worker.sums.record_bytes += bytes;
  if (primitive.polygon) worker.sums.umbra_record_bytes += bytes;
  if (worker.sums.pixels_covered == covered_before) worker.sums.degenerate_wedges += 1;
}

std::vector<CountResult> Traversal::finish() {
  std::vector<CountResult> results(configs_.size());
  const FrameSummary right =
      FinishedFrame(frame_, image_, options_.datapath, {}).summarize(trace_, method_);
  for (const auto& [tile, size] : sizes_) {
    for (std::size_t run = 0; run < size.runs.size(); ++run) {
      CountResult& result = results[size.configs[run]];
      result.config = size.runs[run]->config;
      result.z = method_;
      finish_config(size, run, right, result);
    }
  }
  return results;
}

void Traversal::finish_config(const TileSize& size, std::size_t index, const FrameSummary& right,
                              CountResult& result) {
  result.counters = std::make_unique<Counters>();
  Counters& counters = *result.counters;
  ConfigRun& run = *size.runs[index];
  std::vector<Correction> corrections = collect(size, index, result);
  result.wrong_contributions = corrections.size();
  const bool wrong = !corrections.empty();
  const FinishedFrame finished(frame_, image_, options_.datapath, std::move(corrections));
  const FrameSummary summary = wrong ? finished.summarize(trace_, method_) : right;
  const bool three_pass = run.config.mode == Mode::three_pass;
  counters.pixels_covered = sums_.pixels_covered;
  counters.pixels_inside = sums_.pixels_inside;
  counters.degenerate_wedges = sums_.degenerate_wedges;
  counters.wedge_bytes = sums_.record_bytes + (three_pass ? sums_.umbra_record_bytes : 0);
  counters.z_reads_min = bit_count(run.z_touched);
  counters.li_writes_min = bit_count(run.li_touched);
  counters.z_reads_floor = image_.pixels_inside_any();
  counters.li_writes_floor = summary.li_writes_floor;
  counters.li_overflow_pixels = three_pass ? summary.any_out_of_range : summary.li_out_of_range;
  result.first_overflow = three_pass ? summary.any_overflow : summary.li_overflow;
  counters.contributions_max = summary.contributions_max;
  const unsigned words = run.face_words | run.umbra_words;
  const std::uint64_t words_a_tile = words == 0 ? 0 : ((words & kZminWord) != 0 ? 2 : 1);
  counters.tile_words = size.depths.count() * words_a_tile;
  counters.tile_build_reads = words == 0 ? 0 : build_reads(run);
  finish_traffic(counters, run.config.mode, trace_.header.depth_format, trace_.depth.size(),
                 summary.stencil_not_zero, options_.datapath.word_bytes());
  result.pixels = summary.pixels;
  if (!options_.maps) return;
  result.z_reads = by_rows(std::move(run.z_reads));
  result.li_writes = by_rows(std::move(run.li_writes));
  result.li = finished.words();
}

std::vector<Correction> Traversal::collect(const TileSize& size, std::size_t run,
                                           CountResult& result) {
  Counters& counters = *result.counters;
  std::vector<Correction> corrections;
  const auto tally =
      static_cast<std::size_t>(std::distance(sizes_.begin(), sizes_.find(size.depths.tile())));
  for (Worker& worker : workers_) {
    TileTally& part = worker.tallies[tally];
    for (std::size_t i = 0; i < counters.counters().size(); ++i) {
      *counters.counters()[i] += part.counters(run).counters()[i]->value();
    }
    result.needless_visits += part.needless_visits();
    result.penumbra_z_reads += part.penumbra_z_reads(run);
    const auto& wrong = part.corrections(run);
    corrections.insert(corrections.end(), wrong.begin(), wrong.end());
  }
  return corrections;
}

std::uint64_t Traversal::build_reads(const ConfigRun& run) const {
  if (run.config.tile_build == TileBuild::none) return 0;
  if (run.config.tile_build == TileBuild::eager) return trace_.depth.size();
  std::uint64_t reads = 0;
  for (std::size_t i = 0; i < run.tiles_visited.size(); ++i) {
    for_each_bit(run.tiles_visited[i], [&](int bit) {
      reads += run.tiles->pixels(64 * i + static_cast<std::size_t>(bit));
    });
  }
  return reads;
}

std::vector<std::uint32_t> Traversal::by_rows(std::vector<std::uint32_t> map) const {
  std::vector<std::uint32_t> rows;
  rows.reserve(trace_.depth.size());
  for (int y = 0; y < frame_.height(); ++y) {
    for (int x = 0; x < frame_.width(); ++x) rows.push_back(map[frame_.position(x, y)]);
  }
  return rows;
}

std::size_t batch_size(const TraceView& trace, bool maps) {
  const std::uint64_t pixels = trace.depth.size();
  const std::uint64_t bytes = pixels / 4 + pixels / 32 + (maps ? 8 * pixels : 0) + 1;
  return static_cast<std::size_t>(std::max<std::uint64_t>(1, kBatchBytes / bytes));
}

std::vector<CountResult> count_batch(const TraceView& trace, ZMethod method,
                                     const CountOptions& options,
                                     std::span<const CountConfig> configs) {
  const auto start = std::chrono::steady_clock::now();
  Traversal traversal(trace, method, options, configs);
  traversal.walk();
  std::vector<CountResult> results = traversal.finish();
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - start;
  for (CountResult& result : results) result.seconds = elapsed.count();
  return results;
}

}  // namespace

ZMethod resolve_z(const TraceView& trace, ZChoice choice) {
  return uses_z_fail(choice, trace.header.z_fail_needed) ? ZMethod::fail : ZMethod::pass;
}

std::vector<CountResult> count(const TraceView& trace, std::span<const CountConfig> configs,
                               const CountOptions& options) {
  if (options.datapath.kind == DatapathKind::fixed) {
    datapath::require_form_bits(options.datapath.formats.form_bits, trace.header.depth_format,
                                trace.header.width, trace.header.height, "formats");
  }
  std::map<ZMethod, std::vector<std::size_t>> by_method;
  for (std::size_t i = 0; i < configs.size(); ++i) {
    check(configs[i]);
    by_method[resolve_z(trace, configs[i].z)].push_back(i);
  }
  std::vector<CountResult> results(configs.size());
  std::optional<tbb::global_control> more_than_cores;
  if (options.threads > 0) {
    more_than_cores.emplace(tbb::global_control::max_allowed_parallelism, options.threads);
  }
  tbb::task_arena arena(options.threads == 0 ? tbb::task_arena::automatic
                                             : static_cast<int>(options.threads));
  const std::size_t limit = batch_size(trace, options.maps);
  for (const auto& entry : by_method) {
    const std::span<const std::size_t> indices = entry.second;
    for (std::size_t first = 0; first < indices.size(); first += limit) {
      const auto batch = indices.subspan(first, std::min(limit, indices.size() - first));
      std::vector<CountConfig> part;
      for (std::size_t i : batch) part.push_back(configs[i]);
      arena.execute([&] {
        std::vector<CountResult> counted = count_batch(trace, entry.first, options, part);
        for (std::size_t i = 0; i < batch.size(); ++i) results[batch[i]] = std::move(counted[i]);
      });
    }
  }
  return results;
}

}  // namespace wedgesim::model
