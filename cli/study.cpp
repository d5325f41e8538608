#include <fmt/format.h>

#include <cstdlib>
#include <memory>

#include "cli/command.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "cli/study_output.h"
#include "reports/page/study_page.h"
#include "reports/runner/estimate.h"
#include "reports/runner/metrics.h"
#include "reports/runner/runner.h"
#include "reports/runner/store.h"
#include "reports/runner/summary.h"
#include "reports/table.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string name, folder, scenes, size, jobs, shard, claims;
  bool retry = false, list_metrics = false, dry_run = false;
};

reports::Study read_study(const Arguments& arguments) {
  if (arguments.name.empty()) {
    throw InputError("wedgesim study", "no NAME given", "a study, or a command that works on one");
  }
  reports::FrameOverrides overrides;
  if (!arguments.scenes.empty()) overrides.scenes = parse_list("--scenes", arguments.scenes);
  if (!arguments.size.empty()) overrides.size = parse_size("--size", arguments.size);
  return reports::read_study(arguments.name, overrides);
}

// Each shard has a folder of its own.
reports::RunOptions options_of(const Arguments& arguments, const std::string& name) {
  reports::RunOptions options;
  options.folder = arguments.folder.empty() ? "out/" + name : arguments.folder;
  options.retry = arguments.retry;
  if (!arguments.jobs.empty()) {
    options.jobs = static_cast<unsigned>(parse_integer("--jobs", arguments.jobs, 1, 1024));
  }
  if (!arguments.shard.empty()) {
    options.shard = reports::parse_shard(arguments.shard);
  } else if (const auto found = reports::shard_of_scheduler(
                 [](const char* variable) { return std::getenv(variable); })) {
    options.shard = found->first;
    print_note(fmt::format("{}: {}", found->second, found->first.name()));
  }
  if (options.shard.of > 1) options.folder /= options.shard.name();
  return options;
}

std::string counts_text(const reports::RunCounts& counts) {
  if (counts.measured == 0 && counts.rendered == 0) {
    return fmt::format("All {} points were there already: nothing was computed.", counts.points);
  }
  if (counts.kept == 0) return {};
  return fmt::format("{} of {} points were there already, {} were measured.", counts.kept,
                     counts.points, counts.measured);
}

int list_metrics() {
  reports::Table table;
  for (const char* title : {"metric", "unit", "what"}) {
    table.add_column(title, reports::Table::Align::left);
  }
  for (const reports::MetricInfo& metric : reports::metrics_of(true, true)) {
    table.add_row({metric.name, metric.unit, metric.description});
  }
  print(table.text());
  return 0;
}

int run(const Arguments& arguments) {
  if (arguments.list_metrics) return list_metrics();
  const reports::Study study = read_study(arguments);
  if (!arguments.claims.empty() && !study.head.claims) {
    throw InputError("--claims", study.head.name + " measures no claims",
                     "the study claims, or one with claims = true");
  }
  reports::RunOptions options = options_of(arguments, study.head.name);
  if (arguments.dry_run) {
    print(reports::dry_run(study, options));
    return 0;
  }
  reports::RunCounts counts;
  {
    Progress progress;
    options.progress = [&progress](std::string_view what) { progress.show(what); };
    counts = reports::run_study(study, options);
  }
  const reports::Results results = reports::read_results(options.folder);
  std::string text = write_study(options.folder, results, arguments.claims);
  if (const std::string kept = counts_text(counts); !kept.empty()) text += kept + '\n';
  text += fmt::format(
      "These tables, results.csv, results.json, results.sqlite and traces are in {}/\n"
      "The page: {}\n",
      options.folder.string(), reports::page::page_path(options.folder).string());
  print(text);
  return reports::held(results) ? 0 : 1;
}

}  // namespace

Command add_study(CLI::App& program) {
  CLI::App* app = program.add_subcommand(
      "study", "Sweep configurations over frames, check every pixel, keep tables and pictures");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("NAME", arguments->name,
                  "A built-in study (paper2, ...) or a study file (.toml, docs/studies.md)")
      ->type_name("");
  app->add_option("-o,--output", arguments->folder,
                  "Folder to write, or to go on in; out/NAME without it")
      ->type_name("DIR");
  app->add_option("--scenes", arguments->scenes, "These scenes instead of the study's own frames")
      ->type_name("A,B,...");
  app->add_option("--size", arguments->size, "Pixels; the study's own without it")
      ->type_name("WxH");
  app->add_option("--jobs", arguments->jobs, "Worker processes; one a core without it")
      ->type_name("N");
  app->add_option("--shard", arguments->shard,
                  "The i-th of n parts, into DIR/shard-i-of-n; a Slurm array or mpirun chooses it "
                  "without this")
      ->type_name("i/n");
  app->add_option("--claims", arguments->claims,
                  "Also write the page of the papers' claims here (the study claims)")
      ->type_name("FILE.md");
  app->add_flag("--retry", arguments->retry, "Measure points again that failed before");
  app->add_flag("--dry-run", arguments->dry_run,
                "List all points with the seconds they may take, and do no more");
  app->add_flag("--metrics", arguments->list_metrics, "List all metrics, and do no more");
  app->footer(
      "Example:\n  wedgesim study paper2 -o out/paper2\n"
      "  wedgesim study merge out/paper2/shard-* -o out/paper2");
  std::vector<Command> commands{add_merge(*app), add_compare(*app), add_report(*app)};
  return {app, [arguments] { return run(*arguments); }, std::move(commands)};
}

}  // namespace wedgesim::cli
