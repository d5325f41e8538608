#include <fmt/format.h>

#include <memory>
#include <string>

#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "reports/stress/run.h"
#include "reports/stress/stress_json.h"
#include "reports/stress/stress_text.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string family, seeds = "3", json;
};

int run(const Arguments& arguments) {
  reports::stress::RunOptions options;
  if (!arguments.family.empty()) {
    options.families = parse_set("--family", arguments.family,
                                 [](std::string_view name) { return std::string(name); });
  }
  options.seeds = static_cast<std::uint64_t>(parse_integer("--seeds", arguments.seeds, 1, 1000));
  std::vector<reports::stress::FamilyResult> results;
  {
    Progress progress;
    results = reports::stress::run(options, [&](std::string_view family) {
      progress.show(fmt::format("stress: {}", family));
    });
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json, reports::stress::stress_json(options, results));
  }
  std::string levels;
  if (!options.families.empty()) {
    for (const auto& result : results) levels += reports::stress::levels_text(result) + "\n";
  }
  print(levels + reports::stress::stress_text(results));
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
  app->footer("Example:\n  wedgesim stress --family grazing-edge,offset");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
