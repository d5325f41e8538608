#include <fmt/format.h>

#include <filesystem>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "base/file.h"
#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "cli/scene_arguments.h"
#include "reports/accuracy/accuracy_json.h"
#include "reports/accuracy/accuracy_text.h"

namespace wedgesim::cli {
namespace {

namespace accuracy = reports::accuracy;

struct Arguments {
  std::vector<std::string> scenes, methods;
  SceneArguments scene;  // what holds for every scene
  std::string rays = "4096", repetitions = "5", max_error, budget, json;
};

std::optional<accuracy::Wish> parse_wish(const Arguments& arguments) {
  accuracy::Wish wish;
  if (!arguments.max_error.empty()) {
    wish.max_error = parse_number("--max-error", arguments.max_error, 0.0, 1.0);
  }
  if (!arguments.budget.empty()) {
    wish.budget_seconds = 1e-3 * parse_number("--budget", arguments.budget, 1e-3, 1e9);
  }
  if (!wish.max_error && !wish.budget_seconds) return std::nullopt;
  return wish;
}

std::vector<functional::Scene> load_scenes(const Arguments& arguments) {
  std::vector<functional::Scene> scenes;
  for (const std::string& name : arguments.scenes) {
    SceneArguments one = arguments.scene;
    one.scene = name;
    scenes.push_back(one.load(arguments.json));
  }
  return scenes;
}

int run(const Arguments& arguments) {
  accuracy::MeasureOptions options;
  options.rays = parse_integer("--rays", arguments.rays, 1, 1 << 20);
  options.repetitions = parse_integer("--repetitions", arguments.repetitions, 1, 1000);
  for (const std::string& text : arguments.methods) {
    options.choices.push_back(functional::choose_method("--method", text));
  }
  const std::optional<accuracy::Wish> wish = parse_wish(arguments);
  if (!arguments.json.empty()) require_writable(arguments.json);
  const accuracy::Wish* asked = wish ? &*wish : nullptr;
  std::vector<accuracy::SceneResult> results;
  bool met = true;
  for (functional::Scene& scene : load_scenes(arguments)) {
    const std::string name = scene.name;
    {
      Progress progress;
      results.push_back(accuracy::measure(std::move(scene), options, [&](std::string_view choice) {
        progress.show(fmt::format("accuracy: {}, {}", name, choice));
      }));
    }
    print(accuracy::accuracy_text(results.back(), asked));
    met = met && (!wish || accuracy::recommend(results.back().methods, *wish).method.has_value());
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json, accuracy::accuracy_json(options, results, asked));
  }
  return met ? 0 : 1;
}

}  // namespace

Command add_accuracy(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "accuracy", "Error against run time of every shadow method, beside ray tracing");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("SCENE", arguments->scenes, "Built-in scenes (wedgesim scenes) or scene files")
      ->required()
      ->type_name("");
  arguments->scene.add_options_to(*app);
  app->add_option("--method", arguments->methods,
                  "NAME, NAME-SAMPLES or NAME:KEY=VALUE,…, as often as wanted; else those that "
                  "stand for every method")
      ->type_name("M")
      ->allow_extra_args(false);
  app->add_option("--rays", arguments->rays, "Of the reference, in pixels that need them")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--repetitions", arguments->repetitions, "Of each run time; the median counts")
      ->type_name("N")
      ->capture_default_str();
  app->add_option("--max-error", arguments->max_error,
                  "Recommend the fastest method with at most this RMSE on receivers, 0 to 1")
      ->type_name("E");
  app->add_option("--budget", arguments->budget,
                  "Recommend the most exact method within this run time, milliseconds")
      ->type_name("MS");
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->footer(
      "Exit code 1 if a scene has no method that meets --max-error and --budget.\n"
      "Examples:\n"
      "  wedgesim accuracy plain-columns text2002\n"
      "  wedgesim accuracy overlap --max-error 0.02\n"
      "  wedgesim accuracy columns --method ssv --method sampled-64 --size 320x213");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
