#include <fmt/format.h>

#include <filesystem>
#include <memory>
#include <optional>
#include <string>

#include "base/error.h"
#include "base/file.h"
#include "base/image.h"
#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "reports/stress/case_name.h"
#include "reports/stress/frame.h"
#include "reports/stress/replay.h"
#include "reports/stress/run.h"
#include "reports/stress/shrink.h"
#include "reports/stress/stress_json.h"
#include "reports/stress/stress_page.h"
#include "reports/stress/stress_picture.h"
#include "reports/stress/stress_text.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

namespace stress = reports::stress;

struct Arguments {
  std::string family, seeds, json, replay, out, arithmetic;
  bool shrink = false;
};

stress::Arithmetic parse_arithmetic(std::string_view text) {
  std::vector<std::pair<std::string_view, stress::Arithmetic>> choices;
  for (const stress::Arithmetic a : stress::kArithmetics) choices.emplace_back(name_of(a), a);
  return parse_choice<stress::Arithmetic>("--arithmetic", text, choices);
}

void refuse_with_replay(const char* option, bool given) {
  if (given) throw InputError(option, "does not go with --replay", "one of the two");
}

// Of the arithmetic that is asked for, or of the first that is beyond its bar.
std::string shrink(const Arguments& arguments, const stress::Case& made,
                   const stress::Measurement& measurement) {
  std::optional<stress::Arithmetic> arithmetic = stress::first_beyond(measurement);
  if (!arguments.arithmetic.empty()) {
    arithmetic = parse_arithmetic(arguments.arithmetic);
  }
  std::optional<stress::Shrunk> shrunk;
  if (arithmetic) shrunk = stress::shrink(made, measurement, *arithmetic);
  if (!shrunk) return "\nnothing to shrink: no pixel is beyond the bar (not leaks, jumps, RMS)\n";
  return "\n" + stress::shrunk_text(*shrunk);
}

int replay(const Arguments& arguments) {
  refuse_with_replay("--family", !arguments.family.empty());
  refuse_with_replay("--json", !arguments.json.empty());
  refuse_with_replay("--seeds", !arguments.seeds.empty());
  const stress::CaseName name = stress::parse_case("--replay", arguments.replay);
  if (!arguments.arithmetic.empty()) parse_arithmetic(arguments.arithmetic);
  const std::filesystem::path file = std::filesystem::path(arguments.out).filename();
  if (!arguments.out.empty() && (file.empty() || file == "." || file == "..")) {
    throw InputError(arguments.out, "is a folder",
                     "with --replay a file name, to be ended by .png and .wtrace");
  }
  const std::string png = arguments.out + ".png";
  const std::string trace = arguments.out + ".wtrace";
  if (!arguments.out.empty()) {
    require_writable(png);
    require_writable(trace);
  }
  const stress::Case made = name.make();
  const stress::Measurement measurement = stress::measure(made);
  if (!arguments.out.empty() && !measurement.refused) {
    write_image(png, stress::picture_of(measurement, stress::kArithmetics,
                                        stress::visible_scale(measurement)));
    traces::write_trace(trace, stress::frame_of(made).trace);
  }
  std::string text = stress::replay_text(name, measurement);
  if (arguments.shrink && !measurement.refused) text += shrink(arguments, made, measurement);
  if (!arguments.out.empty() && measurement.refused) text += "no picture and no trace of it\n";
  if (arguments.shrink && measurement.refused) text += "nothing to shrink\n";
  print(text);
  return stress::replay_holds(name, measurement) ? 0 : 1;
}

int run(const Arguments& arguments) {
  if (!arguments.arithmetic.empty() && !arguments.shrink) {
    throw InputError("--arithmetic", "goes with --shrink alone", "--replay and --shrink, too");
  }
  if (!arguments.replay.empty()) return replay(arguments);
  if (arguments.shrink) throw InputError("--shrink", "has nothing to shrink", "--replay, too");
  stress::RunOptions options;
  if (!arguments.family.empty()) {
    options.families = parse_set("--family", arguments.family,
                                 [](std::string_view name) { return std::string(name); });
  }
  if (!arguments.seeds.empty()) {
    options.seeds = static_cast<std::uint64_t>(parse_integer("--seeds", arguments.seeds, 1, 1000));
  }
  if (!arguments.out.empty()) stress::require_stress_writable(arguments.out);
  if (!arguments.json.empty()) {
    require_writable(arguments.json);
    if (!arguments.out.empty()) {
      std::vector<std::filesystem::path> outputs = stress::stress_files(arguments.out);
      outputs.emplace_back(arguments.json);
      require_apart(outputs);
    }
  }
  std::vector<stress::FamilyResult> results;
  {
    Progress progress;
    results = stress::run(
        options, [&progress](const stress::Family& family, std::size_t place, std::size_t count) {
          progress.show(fmt::format("stress: {} ({} of {})", family.name, place + 1, count));
        });
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json, stress::stress_json(options, results));
  }
  std::string levels;
  if (!options.families.empty()) {
    for (const auto& result : results) levels += stress::levels_text(result) + "\n";
  }
  if (!arguments.out.empty()) stress::write_stress(arguments.out, options, results);
  print(levels + stress::stress_text(results));
  for (const auto& result : results) {
    if (!result.complaints().empty()) return 1;
  }
  return 0;
}

}  // namespace

Command add_stress(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "stress", "Numerical stability: every arithmetic against a 200-bit judge on extreme cases");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("--family", arguments->family, "Families, with their levels; all if not given")
      ->type_name("SET");
  app->add_option("--seeds", arguments->seeds, "Cases of each family and level, 1 to 1000; 3")
      ->type_name("N");
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option("--replay", arguments->replay, "Draw one case again: its errors, worst pixels")
      ->type_name("FAMILY,SEED,DIFFICULTY");
  app->add_flag("--shrink", arguments->shrink,
                "With --replay: the fewest edges that alone show the failure");
  app->add_option("--arithmetic", arguments->arithmetic,
                  "With --shrink: fixed, float32, double or renderer; else the first that fails")
      ->type_name("NAME");
  app->add_option("-o,--output", arguments->out,
                  "A folder for stress.html, stress.json and pictures of first failures; with "
                  "--replay OUT.png, the case's pictures, and OUT.wtrace, its trace")
      ->type_name("OUT");
  app->footer(
      "Examples:\n"
      "  wedgesim stress -o out/stress\n"
      "  wedgesim stress --family grazing-edge,offset\n"
      "  wedgesim stress --replay small-light,1,1e-8 -o small\n"
      "  wedgesim stress --replay line-light,0,1e-8 --shrink --arithmetic fixed");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
