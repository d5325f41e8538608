#include "reports/cycles.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <vector>

#include "base/file.h"
#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "reports/memory_trace.h"
#include "reports/timeline.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string file, config = "paper2-single", json, memory_trace, memory_trace_format = "csv",
                    memory_trace_request_bytes = "64", memory_trace_mhz, energy, maps, timeline,
                    vcd, window;
  bool clocked = false, print_config = false;
};

std::optional<model::memory::EnergyTable> energy_of(const Arguments& arguments) {
  if (arguments.energy.empty()) return {};
  return model::memory::read_energy(std::filesystem::path(arguments.energy));
}

reports::MemoryTraceOptions memory_trace_of(const Arguments& arguments,
                                            const model::BlockConfig& config,
                                            std::uint64_t checksum) {
  reports::MemoryTraceOptions options;
  options.format =
      reports::memory_trace_format(arguments.memory_trace_format, "--memory-trace-format");
  options.request_bytes =
      parse_integer("--memory-trace-request-bytes", arguments.memory_trace_request_bytes, 8, 4096);
  options.block_mhz = config.clock_mhz;
  options.memory_mhz = config.memory.dram.clock_mhz;
  if (!arguments.memory_trace_mhz.empty()) {
    options.memory_mhz = parse_integer("--memory-trace-mhz", arguments.memory_trace_mhz, 1, 10000);
  }
  options.configuration = reports::hash_of(config);
  options.trace = fmt::format("{:016x}", checksum);
  return options;
}

reports::CyclesReport run_block(const Arguments& arguments, const traces::TraceView& trace,
                                const model::BlockConfig& config, reports::Timeline* timeline) {
  const std::optional<model::memory::EnergyTable> energy = energy_of(arguments);
  const model::memory::EnergyTable* table = energy ? &*energy : nullptr;
  model::BlockOptions options;
  if (arguments.clocked) options.timing = model::units::Timing::clocked;
  if (timeline != nullptr) {
    options.states = [timeline](std::string_view unit, model::units::UnitState state,
                                model::memory::Cycle begin, model::memory::Cycle end) {
      timeline->add(unit, state, begin, end);
    };
  }
  Progress progress;
  progress.show(fmt::format("{}: the block at work", trace.header.name));
  const reports::CheckedFrame frame = reports::check_frame(trace, config);
  if (arguments.memory_trace.empty()) return reports::run_cycles(frame, config, options, table);
  const reports::MemoryTraceOptions trace_options =
      memory_trace_of(arguments, config, trace.header.checksum);
  std::optional<reports::CyclesReport> report;
  write_stream(arguments.memory_trace, [&](std::ostream& out) {
    reports::MemoryTraceWriter writer(out, trace_options);
    options.listener = [&writer](const auto& record) { writer.write(record); };
    report = reports::run_cycles(frame, config, options, table);
  });
  return *report;
}

// The cycles that a timeline shows: all, or a window.
reports::Timeline timeline_of(const Arguments& arguments) {
  std::pair<std::uint64_t, std::uint64_t> window{0, std::numeric_limits<std::uint64_t>::max()};
  if (!arguments.window.empty()) window = parse_window("--window", arguments.window);
  return {window.first, window.second, model::kBlockUnits};
}

std::vector<std::filesystem::path> outputs_of(const Arguments& arguments) {
  std::vector<std::filesystem::path> outputs;
  for (const char* map : {"_tile_bytes", "_tile_cycles"}) {
    for (const char* kind : {".png", ".exr"}) {
      if (!arguments.maps.empty()) outputs.emplace_back(arguments.maps + map + kind);
    }
  }
  for (const std::string& output :
       {arguments.json, arguments.memory_trace, arguments.timeline, arguments.vcd}) {
    if (!output.empty()) outputs.emplace_back(output);
  }
  return outputs;
}

int run(const Arguments& arguments) {
  const model::BlockConfig config = model::read_block(arguments.config);
  if (arguments.print_config) {
    print(model::to_toml(config));
    return 0;
  }
  if (arguments.file.empty()) throw InputError("wedgesim cycles", "no FILE given", "a trace");
  const traces::TraceFile trace(arguments.file);
  const std::array inputs{std::filesystem::path(arguments.file),
                          std::filesystem::path(arguments.config),
                          std::filesystem::path(arguments.energy)};
  const std::vector<std::filesystem::path> outputs = outputs_of(arguments);
  for (const auto& output : outputs) require_not_read(output, inputs);
  require_apart(outputs);
  for (const auto& output : outputs) require_writable(output);
  reports::Timeline timeline = timeline_of(arguments);
  const bool listens = !arguments.timeline.empty() || !arguments.vcd.empty();
  const reports::CyclesReport report =
      run_block(arguments, trace.view(), config, listens ? &timeline : nullptr);
  if (!arguments.timeline.empty()) {
    write_stream(arguments.timeline, [&](std::ostream& out) { timeline.write_chrome(out); });
  }
  if (!arguments.vcd.empty()) {
    write_stream(arguments.vcd, [&](std::ostream& out) { timeline.write_vcd(out); });
  }
  if (!arguments.json.empty()) reports::write_json(arguments.json, reports::cycles_json(report));
  const std::string maps =
      arguments.maps.empty() ? "" : reports::write_tile_maps(arguments.maps, report);
  print(reports::cycles_text(report) + maps);
  return reports::held(report) ? 0 : 1;
}

}  // namespace

Command add_cycles(CLI::App& program) {
  CLI::App* app = program.add_subcommand("cycles", "Run a trace through the block, in time");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("FILE", arguments->file, "A trace")->type_name("");
  app->add_option("--config", arguments->config,
                  "paper2-single, paper2-three, small, wide, or a TOML file")
      ->type_name("NAME|FILE")
      ->capture_default_str();
  app->add_flag("--print-config", arguments->print_config,
                "Write the effective configuration as TOML, and do no more");
  app->add_flag("--clocked", arguments->clocked, "Step every unit through every cycle: slow");
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option("--memory-trace", arguments->memory_trace, "Write every access at the port")
      ->type_name("FILE");
  app->add_option("--memory-trace-format", arguments->memory_trace_format,
                  "Of that file: csv, dramsys, dramsim3, ramulator")
      ->type_name("NAME")
      ->capture_default_str();
  app->add_option("--memory-trace-request-bytes", arguments->memory_trace_request_bytes,
                  "dramsim3, ramulator: what a line stands for, a power of two from 8 to 4096")
      ->type_name("N")
      ->capture_default_str();
  app->add_option(
         "--memory-trace-mhz", arguments->memory_trace_mhz,
         "dramsim3: the memory clock that it counts in; without it the DRAM's, 1600 behind "
         "an ideal memory")
      ->type_name("N");
  app->add_option("--energy", arguments->energy,
                  "What accesses cost, TOML: datapath_word_pj, cache_access_pj, dram_byte_pj, "
                  "dram_activate_pj")
      ->type_name("FILE");
  app->add_option("--maps", arguments->maps,
                  "Write maps of the tiles: PREFIX_tile_bytes, PREFIX_tile_cycles as .png and .exr")
      ->type_name("PREFIX");
  app->add_option("--timeline", arguments->timeline,
                  "Write what each unit does when, for Perfetto or Chrome's tracing")
      ->type_name("FILE");
  app->add_option("--vcd", arguments->vcd, "The same as a value change dump")->type_name("FILE");
  app->add_option("--window", arguments->window, "Cycles that both show; all without it")
      ->type_name("BEGIN,END");
  app->footer("Example:\n  wedgesim cycles out/paper2/bunny.wtrace --config paper2-single");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
