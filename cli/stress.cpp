#include <fmt/format.h>

#include <memory>
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
#include "reports/stress/stress_json.h"
#include "reports/stress/stress_picture.h"
#include "reports/stress/stress_text.h"
#include "traces/writer.h"

namespace wedgesim::cli {
namespace {

namespace stress = reports::stress;

struct Arguments {
  std::string family, seeds = "3", json, replay, out;
};

void refuse_with_replay(const char* option, bool given) {
  if (given) throw InputError(option, "does not go with --replay", "one of the two");
}

int replay(const Arguments& arguments) {
  refuse_with_replay("--family", !arguments.family.empty());
  refuse_with_replay("--json", !arguments.json.empty());
  const stress::CaseName name = stress::parse_case("--replay", arguments.replay);
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
  print(stress::replay_text(name, measurement));
  return stress::replay_holds(name, measurement) ? 0 : 1;
}

int run(const Arguments& arguments) {
  if (!arguments.replay.empty()) return replay(arguments);
  stress::RunOptions options;
  if (!arguments.family.empty()) {
    options.families = parse_set("--family", arguments.family,
                                 [](std::string_view name) { return std::string(name); });
  }
  options.seeds = static_cast<std::uint64_t>(parse_integer("--seeds", arguments.seeds, 1, 1000));
  std::vector<stress::FamilyResult> results;
  {
    Progress progress;
    results = stress::run(options, [&](std::string_view family) {
      progress.show(fmt::format("stress: {}", family));
    });
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json, stress::stress_json(options, results));
  }
  std::string levels;
  if (!options.families.empty()) {
    for (const auto& result : results) levels += stress::levels_text(result) + "\n";
  }
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
  app->add_option("--seeds", arguments->seeds, "Cases of each family and level, 1 to 1000")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option("--replay", arguments->replay, "Draw one case again: its errors, worst pixels")
      ->type_name("FAMILY,SEED,DIFFICULTY");
  app->add_option("-o,--output", arguments->out,
                  "With --replay: write OUT.png, the case's pictures, and OUT.wtrace, its trace")
      ->type_name("OUT");
  app->footer(
      "Examples:\n"
      "  wedgesim stress --family grazing-edge,offset\n"
      "  wedgesim stress --replay small-light,0,1e-8 -o small");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
