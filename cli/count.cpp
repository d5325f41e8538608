#include "model/count/count.h"

#include <fmt/format.h>

#include <array>
#include <filesystem>
#include <memory>

#include "base/file.h"
#include "cli/command.h"
#include "cli/count_arguments.h"
#include "cli/parse.h"
#include "cli/print.h"
#include "cli/progress.h"
#include "reports/count_text.h"
#include "reports/json.h"
#include "reports/map_files.h"
#include "reports/maps.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  CountArguments count;
  std::string file, json, maps, datapath = "exact", formats, needs = "all";
};

model::Datapath datapath_of(const Arguments& arguments) {
  model::Datapath datapath(model::parse<model::DatapathKind>("--datapath", arguments.datapath));
  if (arguments.formats.empty()) return datapath;
  if (datapath.kind != model::DatapathKind::fixed) {
    throw InputError("--formats", "given with --datapath " + arguments.datapath,
                     "--datapath fixed, the one whose widths may be chosen");
  }
  datapath.formats = model::datapath::read_formats(arguments.formats);
  return datapath;
}

int run(const Arguments& arguments) {
  const std::vector<model::CountConfig> configs = arguments.count.configs();
  model::CountOptions options;
  options.datapath = datapath_of(arguments);
  options.maps = !arguments.maps.empty();
  parse_choice<int>("--needs", arguments.needs, {{"all", 0}});
  if (options.maps && configs.size() != 1) {
    throw InputError("--maps", fmt::format("given with {} configurations", configs.size()),
                     "one: --mode single-pass or three-pass, one value of each set");
  }
  const traces::TraceFile trace(arguments.file);
  std::vector<std::filesystem::path> outputs;
  if (options.maps) outputs = reports::map_files(arguments.maps);
  if (!arguments.json.empty()) outputs.emplace_back(arguments.json);
  const std::array inputs{std::filesystem::path(arguments.file),
                          std::filesystem::path(arguments.formats)};
  for (const auto& output : outputs) require_not_read(output, inputs);
  require_apart(outputs);
  const reports::TraceInfo info = reports::info_of(trace.view());
  std::vector<model::CountResult> results;
  {
    Progress progress;
    progress.show(fmt::format("{}: counting in {} configurations", info.name, configs.size()));
    results = model::count(trace.view(), configs, options);
  }
  const auto flagged = model::flag_wedges(trace.view(), options.datapath);
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json,
                        reports::count_json(info, results, options.datapath, flagged));
  }
  std::string maps;
  if (options.maps) {
    maps =
        fmt::format("maps: {}\n", to_text(reports::write_maps(arguments.maps, trace.view(),
                                                              results.front(), options.datapath)));
  }
  print(reports::count_text(info, results) + reports::flags_text(flagged) + maps);
  return reports::held(results) ? 0 : 1;
}

}  // namespace

Command add_count(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("count", "Count the memory accesses of a trace and check every pixel");
  auto arguments = std::make_shared<Arguments>();
  app->add_option("FILE", arguments->file, "A trace")->required()->type_name("");
  arguments->count.add_to(*app);
  app->add_option(
         "--datapath", arguments->datapath,
         "Arithmetic: double precision, the hardware's integers, LI words of 255 as in Papers "
         "I and II, or a shader's single precision")
      ->type_name("exact|fixed|paper255|float32")
      ->capture_default_str();
  app->add_option("--formats", arguments->formats, "Widths of the fixed datapath, TOML")
      ->type_name("FILE");
  app->add_option("--needs", arguments->needs, "Casters that are counted")
      ->type_name("all")
      ->capture_default_str();
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option("--maps", arguments->maps,
                  "Write maps of one configuration: PREFIX_z_reads, PREFIX_li_writes, PREFIX_li, "
                  "PREFIX_difference as .png and .exr")
      ->type_name("PREFIX");
  app->footer(
      "A SET is one value or several with commas, none twice; all combinations are counted.\n"
      "Example:\n  wedgesim count columns.wtrace --tile 4,8,16");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
