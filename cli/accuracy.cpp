#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
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
#include "reports/accuracy/accuracy_charts.h"
#include "reports/accuracy/accuracy_json.h"
#include "reports/accuracy/accuracy_page.h"
#include "reports/accuracy/accuracy_text.h"
#include "reports/accuracy/claim_results.h"
#include "reports/accuracy/published.h"
#include "reports/accuracy/views.h"
#include "reports/claims/claims.h"

namespace wedgesim::cli {
namespace {

namespace accuracy = reports::accuracy;

struct Arguments {
  std::vector<std::string> scenes, methods;
  SceneArguments scene;  // what holds for every scene
  std::string rays = "4096", repetitions = "5", max_error, budget, json, out, claims, meshes = ".";
  bool published = false;
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

/// A scene to be measured and the choices of method on it; none: what stands for every method.
struct Job {
  std::string name;  // of a scene, or a view
  std::vector<functional::MethodChoice> choices;
  std::optional<functional::Scene> scene = {};
};

std::vector<Job> jobs_of(const Arguments& arguments) {
  std::vector<functional::MethodChoice> choices;
  for (const std::string& text : arguments.methods) {
    choices.push_back(functional::choose_method("--method", text));
  }
  std::vector<Job> jobs;
  for (const std::string& scene : arguments.scenes) {
    jobs.push_back({.name = scene, .choices = choices});
  }
  if (arguments.published) {
    for (const accuracy::View& view : accuracy::built_in_views()) {
      if (view.published) jobs.push_back({.name = view.name, .choices = choices});
    }
  }
  if (!arguments.claims.empty()) {
    for (const auto& [scene, texts] : accuracy::work_of(reports::method_claims())) {
      Job& job = jobs.emplace_back(Job{.name = scene, .choices = {}});
      for (const std::string& text : texts) {
        job.choices.push_back(functional::choose_method("reports/claims.toml", text));
      }
    }
  }
  return jobs;
}

// Nothing for a view whose mesh is not there, which is noted.
std::optional<functional::Scene> load_scene(const Arguments& arguments, const std::string& name) {
  const auto& views = accuracy::built_in_views();
  const auto view = std::ranges::find(views, name, &accuracy::View::name);
  if (view == views.end()) {
    SceneArguments one = arguments.scene;
    one.scene = name;
    return one.load(arguments.json);
  }
  if (!arguments.scene.is_default()) {
    throw InputError(name, "is a view, whose size, frame, light and mesh are its own",
                     "no option that changes the scene");
  }
  std::optional<functional::Scene> scene = view->load(arguments.meshes);
  if (!scene) {
    print_note(
        fmt::format("{} is left out: {} is not there (--meshes)", name,
                    (std::filesystem::path(arguments.meshes) / *view->options.mesh).string()));
  }
  return scene;
}

void check_what_is_measured(const Arguments& arguments) {
  const int given = (arguments.scenes.empty() ? 0 : 1) + (arguments.published ? 1 : 0) +
                    (arguments.claims.empty() ? 0 : 1);
  if (given != 1) {
    throw InputError("accuracy", given == 0 ? "has nothing to measure" : "has several things to do",
                     "scenes, --published or --claims");
  }
  if (!arguments.claims.empty() && !arguments.methods.empty()) {
    throw InputError("--method", "does not go with --claims", "one of the two");
  }
  if (arguments.scenes.empty() && !arguments.scene.is_default()) {
    throw InputError(arguments.published ? "--published" : "--claims",
                     "has scenes of its own size, frame, light and mesh",
                     "no option that changes the scene");
  }
}

std::vector<accuracy::ShownArtifact> find_artifacts(
    const std::vector<accuracy::SceneResult>& results, int rays) {
  Progress progress;
  return accuracy::show_artifacts(
      accuracy::method_names(results), rays,
      [&](std::string_view name) { progress.show(fmt::format("accuracy: artifact {}", name)); });
}

int run(const Arguments& arguments) {
  accuracy::MeasureOptions options;
  options.rays = parse_integer("--rays", arguments.rays, 1, 1 << 20);
  options.repetitions = parse_integer("--repetitions", arguments.repetitions, 1, 1000);
  check_what_is_measured(arguments);
  const std::optional<accuracy::Wish> wish = parse_wish(arguments);
  for (const std::string& output : {arguments.json, arguments.claims}) {
    if (!output.empty()) require_writable(output);
  }
  if (!arguments.out.empty()) {
    require_writable(std::filesystem::path(arguments.out) / "accuracy.html");
  }
  const accuracy::Wish* asked = wish ? &*wish : nullptr;
  std::vector<accuracy::SceneResult> results;
  std::vector<accuracy::Pictures> pictures;
  bool met = true;
  std::vector<Job> jobs = jobs_of(arguments);
  for (Job& job : jobs) job.scene = load_scene(arguments, job.name);  // all, before work begins
  std::erase_if(jobs, [](const Job& job) { return !job.scene; });
  for (Job& job : jobs) {
    const std::string name = job.scene->name;
    options.choices = job.choices;
    {
      Progress progress;
      results.push_back(
          accuracy::measure(std::move(*job.scene), options, [&](std::string_view choice) {
            progress.show(fmt::format("accuracy: {}, {}", name, choice));
          }));
    }
    print(accuracy::accuracy_text(results.back(), asked));
    if (!arguments.out.empty()) {
      pictures.push_back(accuracy::write_pictures(arguments.out, results));
    }
    for (accuracy::Measured& measured : results.back().methods) measured.visibility.clear();
    met = met && (!wish || accuracy::recommend(results.back().methods, *wish).method.has_value());
  }
  std::vector<accuracy::ShownArtifact> artifacts;
  if (!arguments.out.empty()) {
    const auto written =
        accuracy::write_artifacts(arguments.out, find_artifacts(results, options.rays));
    accuracy::write_accuracy(arguments.out, {options, results, pictures, written}, asked);
    std::ranges::transform(written, std::back_inserter(artifacts),
                           &accuracy::ArtifactPictures::shown);
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json,
                        accuracy::accuracy_json(options, results, asked, artifacts));
  }
  print(accuracy::published_text(results));
  if (!arguments.claims.empty()) {
    const reports::Results measured = accuracy::claim_results(results);
    const auto judged = reports::judge_claims(reports::method_claims(), measured);
    write_file(arguments.claims, reports::claims_page(judged, measured).markdown());
    print("\n" + reports::claims_table(judged).text());
  }
  return met ? 0 : 1;
}

}  // namespace

Command add_accuracy(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "accuracy", "Error against run time of every shadow method, beside ray tracing");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("SCENE", arguments->scenes,
                  "Built-in scenes (wedgesim scenes), scene files, or views (docs/accuracy.md)")
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
  app->add_flag("--published", arguments->published,
                "The views that have the sizes of the papers' tables");
  app->add_option("--claims", arguments->claims,
                  "Measure what the papers claim of methods and write the page of verdicts here")
      ->type_name("FILE");
  app->add_option("--meshes", arguments->meshes, "Where relative paths of the views' meshes start")
      ->type_name("DIR")
      ->capture_default_str();
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option(
         "-o,--output", arguments->out,
         "A folder for accuracy.html, accuracy.json and pictures/SCENE_METHOD.png: method, "
         "reference, difference")
      ->type_name("DIR");
  app->footer(
      "Exit code 1 if a scene has no method that meets --max-error and --budget.\n"
      "Examples:\n"
      "  wedgesim accuracy plain-columns text2002 -o out/accuracy\n"
      "  wedgesim accuracy overlap --max-error 0.02\n"
      "  wedgesim accuracy columns --method ssv --method sampled-64 --size 320x213");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
