#include "reports/study.h"

#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "reports/study_text.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string name, folder, scenes, size;
};

int run(const Arguments& arguments) {
  reports::Study study = reports::built_in_study(arguments.name);
  if (!arguments.scenes.empty()) study.scenes = parse_list("--scenes", arguments.scenes);
  if (!arguments.size.empty()) study.size = parse_size("--size", arguments.size);
  const std::string folder = arguments.folder.empty() ? "out/" + study.name : arguments.folder;
  reports::StudyResults results;
  {
    Progress progress;
    results = reports::run_study(study, folder,
                                 [&progress](std::string_view what) { progress.show(what); });
  }
  print(fmt::format("{}\nThese tables, results.csv, results.json, traces and pictures are in {}/\n",
                    reports::study_text(results), folder));
  for (const reports::SceneResults& scene : results.scenes) {
    if (!scene.failure.empty()) throw InputError("left out", scene.failure);
  }
  return reports::held(results) ? 0 : 1;
}

}  // namespace

Command add_study(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "study", "Sweep configurations over scenes, check every pixel, keep tables and pictures");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("NAME", arguments->name, "A built-in study: paper2")->required()->type_name("");
  app->add_option("-o,--output", arguments->folder, "Folder to write; out/NAME without it")
      ->type_name("DIR");
  app->add_option("--scenes", arguments->scenes, "These scenes instead of the study's own")
      ->type_name("A,B,...");
  app->add_option("--size", arguments->size, "Pixels; the scenes' own without it")
      ->type_name("WxH");
  app->footer("Example:\n  wedgesim study paper2 -o out/paper2");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
