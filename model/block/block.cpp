#include "model/block/block.h"

#include <fmt/format.h>
#include <sysc/kernel/sc_kernel_ids.h>
#include <tlm_utils/simple_target_socket.h>

#include <algorithm>
#include <array>

#include "base/check.h"
#include "base/error.h"
#include "model/block/scoped_simulation.h"
#include "model/count/traffic.h"
#include "model/memory/dram.h"
#include "model/memory/ideal_memory.h"

// The library asks for it even where main is the program's own.
int sc_main(int, char**) { return 0; }

namespace wedgesim::model {
namespace {

using memory::Cycle;
using units::Link;
using units::Token;

/// A memory model as a TLM-2.0 target that annotates delays and never waits.
class MemoryTarget final : public sc_core::sc_module {
 public:
  MemoryTarget(sc_core::sc_module_name name, memory::MemoryModel& model)
      : sc_module(name), socket("socket"), model_(model) {
    socket.register_b_transport(this, &MemoryTarget::transport);
  }

  tlm_utils::simple_target_socket<MemoryTarget> socket;

 private:
  void transport(tlm::tlm_generic_payload& payload, sc_core::sc_time& delay) {
    const Cycle at = units::cycle_at(sc_core::sc_time_stamp() + delay);
    const Cycle done =
        model_.access(payload.get_address(), payload.get_data_length(), payload.is_write(), at);
    delay += units::cycles_to_time(done - at);
    payload.set_response_status(tlm::TLM_OK_RESPONSE);
  }

  memory::MemoryModel& model_;
};

std::unique_ptr<memory::MemoryModel> make_memory(const BlockConfig& config) {
  if (config.memory.kind == MemoryKind::ideal) {
    return std::make_unique<memory::IdealMemory>(config.memory.ideal);
  }
  return std::make_unique<memory::Dram>(config.memory.dram, config.clock_mhz);
}

std::vector<Statistic> statistics_of(const Group& group) {
  std::vector<Statistic> statistics;
  for (const Counter* counter : group.counters()) {
    statistics.push_back({std::string(counter->name()), std::string(name_of(counter->unit())),
                          std::string(counter->description()), counter->value()});
  }
  return statistics;
}

/// The top: wires the units.
class Block {
 public:
  Block(const RecordedFrame& frame, const BlockConfig& config, const BlockOptions& options)
      : watchdog_cycles_(options.watchdog_cycles),
        model_(options.target ? nullptr : make_memory(config)),
        layout_(frame.layout),
        port_("memory_port"),
        fetched_("wedge_fetch to wedge_setup", config.wedge_fetch.out),
        prepared_("wedge_setup to tile_walk", config.wedge_setup.out),
        walked_("tile_walk to tile_cull", config.tile_walk.out),
        surviving_("tile_cull to z_read", config.tile_cull.out),
        read_("z_read to penumbra", config.z_read.out),
        lit_("penumbra to li_update", config.penumbra.out),
        wedge_fetch_(
            "wedge_fetch", options.timing, config.wedge_fetch,
            [this, &frame] {
              return next_ < frame.work.size() ? frame.work[next_++].get() : nullptr;
            },
            port_, layout_, fetched_),
        wedge_setup_("wedge_setup", options.timing, config.wedge_setup, fetched_, prepared_),
        tile_walk_("tile_walk", options.timing, config.tile_walk, prepared_, walked_),
        tile_cull_("tile_cull", options.timing, config.tile_cull, port_, layout_,
                   tiles_across(frame), walked_, surviving_),
        z_read_("z_read", options.timing, config.z_read, port_, layout_, surviving_, read_),
        penumbra_("penumbra", options.timing, config.penumbra, read_, lit_),
        li_update_("li_update", options.timing, config.li_update,
                   frame.rasterizer.mode == Mode::three_pass, port_, layout_, lit_) {
    if (options.target) {
      target_ = options.target(port_);
    } else {
      auto target = std::make_unique<MemoryTarget>("memory", *model_);
      port_.socket.bind(target->socket);
      target_ = std::move(target);
      if (options.timing == units::Timing::decoupled) port_.bypass(*model_);
    }
    if (options.listener) port_.listen(options.listener);
    if (options.states) listen_to_states(options);
    li_update_.on_drained([this](Cycle cycle, const units::CriticalPath& path) {
      wedge_fetch_.drained(cycle, path);
    });
    for (std::size_t i = 0; i < all().size(); ++i) all()[i]->time().place_at(i);
  }

  void run() {
    // A start that finds nothing due is no mistake here; the kernel would say so on standard
    // output.
    sc_core::sc_report_handler::set_actions(sc_core::SC_ID_NO_SC_START_ACTIVITY_,
                                            sc_core::SC_DO_NOTHING);
    const sc_core::sc_time slice = units::cycles_to_time(watchdog_cycles_);
    sc_core::sc_time next = slice;
    for (;;) {
      // No further than there is something to do: starved, units may be behind the kernel's slice.
      sc_core::sc_start(std::max(slice, next), sc_core::SC_EXIT_ON_STARVATION);
      if (li_update_.finished()) return;
      if (!sc_core::sc_pending_activity() && !work_ahead()) throw SimulationError(blocked());
      if (leaves_unanswered()) throw SimulationError(blocked());
      next = sc_core::sc_pending_activity() ? sc_core::sc_time_to_pending_activity() : slice;
    }
  }

  BlockResult result() const {
    BlockResult result;
    result.cycles = port_.last_done();
    for (const units::BlockUnit* unit : units()) {
      result.cycles = std::max(result.cycles, unit->time().now());
    }
    for (const units::BlockUnit* unit : units()) {
      const units::UnitTime& time = unit->time();
      const Cycle idle = result.cycles - time.now();  // behind its last item
      result.units.push_back({unit->basename(), time.busy(), time.starved() + idle, time.stalled(),
                              time.memory(), statistics_of(unit->statistics())});
      CHECK_EQ(time.busy() + time.starved() + time.stalled(), time.now());
    }
    add_path(result);
    add_cache(result, "tile_cull", tile_cull_.cache());
    add_cache(result, "z_read", z_read_.cache());
    add_cache(result, "li_update", li_update_.li_cache());
    add_cache(result, "li_update.stencil", li_update_.stencil_cache());
    for (std::size_t i = 0; i < memory::kSurfaces; ++i) {
      const auto surface = static_cast<memory::Surface>(i);
      const auto& traffic = port_.traffic(surface);
      result.traffic.push_back({std::string(memory::name_of(surface)), traffic.reads,
                                traffic.writes, traffic.read_bytes, traffic.write_bytes});
    }
    if (model_) {
      result.memory = statistics_of(model_->statistics());
      result.peak_bytes_per_cycle = model_->peak_bytes_per_cycle();
    }
    return result;
  }

 private:
  void listen_to_states(const BlockOptions& options) {
    for (units::BlockUnit* unit : all()) {
      const std::string name = unit->basename();
      unit->time().listen(
          [name, states = options.states](units::UnitState state, Cycle begin, Cycle end) {
            states(name, state, begin, end);
          });
    }
  }
  static unsigned tiles_across(const RecordedFrame& frame) {
    const unsigned tile = frame.rasterizer.tile;
    return (static_cast<unsigned>(frame.layout.width) + tile - 1) / tile;
  }
  static void add_cache(BlockResult& result, std::string name, const memory::Cache& cache) {
    result.caches.push_back(
        {std::move(name), cache.size_bytes(), cache.hits(), cache.misses(), cache.write_backs()});
  }
  // What the last cycle waited for: the path of the unit that ends last, and the writes behind it.
  void add_path(BlockResult& result) const {
    const auto all = units();
    const auto* const last = *std::max_element(
        all.begin(), all.end(), [](auto* a, auto* b) { return a->time().now() < b->time().now(); });
    using Part = units::CriticalPath::Part;
    units::CriticalPath path = last->time().path();
    path.add(last->time().place(), Part::memory, result.cycles - last->time().now());
    CHECK_EQ(path.total(), result.cycles);
    for (std::size_t i = 0; i < kBlockUnits.size(); ++i) {
      for (const auto& [prefix, part] :
           {std::pair{"", Part::work}, {"memory:", Part::memory}, {"queue:", Part::queue}}) {
        const Cycle cycles = path.of(i, part);
        if (cycles > 0) {
          result.critical_path.push_back({prefix + std::string(kBlockUnits[i]), cycles});
        }
      }
    }
  }
  std::array<units::BlockUnit*, 7> all() {
    return {&wedge_fetch_, &wedge_setup_, &tile_walk_, &tile_cull_,
            &z_read_,      &penumbra_,    &li_update_};
  }
  std::vector<const units::BlockUnit*> units() const {
    return {&wedge_fetch_, &wedge_setup_, &tile_walk_, &tile_cull_,
            &z_read_,      &penumbra_,    &li_update_};
  }
  std::array<const Link<Token>*, 6> links() const {
    return {&fetched_, &prepared_, &walked_, &surviving_, &read_, &lit_};
  }
  // Whoever works on demand does all that can be done.
  bool work_ahead() {
    if (wedge_fetch_.time().timing() == units::Timing::clocked) return false;
    bool any = wedge_setup_.work_ahead();
    any = tile_walk_.work_ahead() || any;
    return penumbra_.work_ahead() || any;
  }
  // Has the target kept an access longer than the watchdog waits?
  bool leaves_unanswered() const {
    const auto waiting = port_.waiting();
    return std::any_of(waiting.begin(), waiting.end(), [this](const auto& access) {
      return units::kernel_cycle() >= access.since + watchdog_cycles_;
    });
  }
  std::string blocked() const {
    Cycle cycle = units::kernel_cycle();
    for (const units::BlockUnit* unit : units()) cycle = std::max(cycle, unit->time().now());
    std::string text = fmt::format("the block is blocked at cycle {}", cycle);
    for (const auto& access : port_.waiting()) {
      text += fmt::format("; memory has not answered {} at {:#x} since cycle {}",
                          memory::name_of(access.surface), access.address, access.since);
    }
    for (const Link<Token>* link : links()) {
      if (link->size() == 0) continue;
      const std::string_view consumer =
          std::string_view(link->name()).substr(link->name().rfind(' ') + 1);
      text += fmt::format("; queue {} holds {} of {}, held by {}", link->name(), link->size(),
                          link->depth(), consumer);
    }
    for (const units::BlockUnit* unit : units()) {
      if (!unit->finished()) text += fmt::format("; {} waits", unit->basename());
    }
    return text;
  }

  const Cycle watchdog_cycles_;
  std::size_t next_ = 0;
  std::unique_ptr<memory::MemoryModel> model_;
  memory::Layout layout_;
  units::MemoryPort port_;
  std::unique_ptr<sc_core::sc_module> target_;
  Link<Token> fetched_, prepared_, walked_, surviving_, read_, lit_;
  units::WedgeFetch wedge_fetch_;
  units::WedgeSetup wedge_setup_;
  units::TileWalk tile_walk_;
  units::TileCull tile_cull_;
  units::ZRead z_read_;
  units::Penumbra penumbra_;
  units::LiUpdate li_update_;
};

}  // namespace

const PathShare& BlockResult::bottleneck() const {
  CHECK_EQ(critical_path.empty(), false);
  return *std::max_element(
      critical_path.begin(), critical_path.end(),
      [](const PathShare& a, const PathShare& b) { return a.cycles < b.cycles; });
}

std::uint64_t BlockResult::port_bytes() const {
  std::uint64_t bytes = 0;
  for (const TrafficResult& surface : traffic) bytes += surface.read_bytes + surface.write_bytes;
  return bytes;
}

RecordedFrame record_frame(const traces::TraceView& trace, const BlockConfig& config) {
  const traces::Header& header = trace.header;
  datapath::require_form_bits(config.formats.form_bits, header.depth_format, header.width,
                              header.height, config.name);
  RecordedFrame frame;
  frame.rasterizer = config.rasterizer;
  frame.z_fail = uses_z_fail(config.rasterizer.z, trace.header.z_fail_needed);
  const auto walk =
      std::make_shared<units::FrameWalk>(trace, config.rasterizer, frame.z_fail, config.formats);
  while (auto work = walk->next()) frame.work.push_back(std::move(work));
  frame.walk = walk;
  memory::LayoutConfig& layout = frame.layout;
  layout.width = static_cast<int>(trace.header.width);
  layout.height = static_cast<int>(trace.header.height);
  layout.tile = static_cast<int>(config.rasterizer.tile);
  layout.z_bytes = static_cast<int>(depth_bytes(trace.header.depth_format));
  layout.li_bytes = static_cast<int>(bytes_of_bits(config.formats.li.bits()));
  layout.stencil_bytes = static_cast<int>(bytes_of_bits(config.formats.stencil_bits));
  layout.wedge_bytes = walk->record_bytes();
  const Counters& counters = frame.counters();
  const auto tiles = static_cast<std::uint64_t>(walk->datapath().depth().tile_count());
  const auto kept = static_cast<int>(counters.tile_words.value() / tiles);
  layout.tile_bytes = layout.z_bytes * std::max(kept, 1);
  return frame;
}

BlockResult run_block(const RecordedFrame& frame, const BlockConfig& config,
                      const BlockOptions& options) {
  const ScopedSimulation simulation;
  Block block(frame, config, options);
  block.run();
  return block.result();
}

}  // namespace wedgesim::model
