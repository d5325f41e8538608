#include "model/count/count.h"

#include <fmt/format.h>

#include <memory>

#include "cli/command.h"
#include "cli/parse.h"
#include "cli/progress.h"
#include "reports/count_text.h"
#include "reports/json.h"
#include "reports/maps.h"
#include "reports/sweep.h"
#include "traces/reader.h"

namespace wedgesim::cli {
namespace {

struct Arguments {
  std::string file, json, maps;
  std::string mode = "single-pass", tile = "8", cull = "both", umbra_cull = "zmax", accept = "none",
              share = "eye", z = "auto", tile_build = "eager", datapath = "exact", needs = "all";
};

template <typename E>
std::vector<E> parse_set(std::string_view option, const std::string& text) {
  std::vector<E> values;
  for (const std::string& part : parse_list(option, text)) {
    values.push_back(model::parse<E>(option, part));
  }
  return values;
}

std::vector<unsigned> parse_tiles(const std::string& text) {
  if (text == "all") return reports::all_tiles();
  std::vector<unsigned> tiles;
  for (const std::string& part : parse_list("--tile", text)) {
    tiles.push_back(model::parse_tile("--tile", part));
  }
  return tiles;
}

std::vector<model::CountConfig> configs_of(const Arguments& arguments) {
  reports::Sweep sweep;
  sweep.modes = parse_set<model::Mode>("--mode", arguments.mode);
  sweep.tiles = parse_tiles(arguments.tile);
  sweep.culls = parse_set<model::Cull>("--cull", arguments.cull);
  sweep.umbra_culls = parse_set<model::UmbraCull>("--umbra-cull", arguments.umbra_cull);
  sweep.accepts = parse_set<model::Accept>("--accept", arguments.accept);
  sweep.shares = parse_set<model::Share>("--share", arguments.share);
  sweep.z = model::parse<model::ZChoice>("--z", arguments.z);
  sweep.tile_build = model::parse<model::TileBuild>("--tile-build", arguments.tile_build);
  return sweep.configs();
}

int run(const Arguments& arguments) {
  const std::vector<model::CountConfig> configs = configs_of(arguments);
  model::CountOptions options;
  options.li_format = model::parse<model::LiFormat>("--datapath", arguments.datapath);
  options.maps = !arguments.maps.empty();
  parse_choice<int>("--needs", arguments.needs, {{"all", 0}});
  if (options.maps && configs.size() != 1) {
    throw InputError("--maps", fmt::format("given with {} configurations", configs.size()),
                     "one configuration");
  }
  const traces::TraceFile trace(arguments.file);
  const reports::TraceInfo info = reports::info_of(trace.view());
  std::vector<model::CountResult> results;
  {
    Progress progress;
    progress.show(fmt::format("{}: counting in {} configurations", info.name, configs.size()));
    results = model::count(trace.view(), configs, options);
  }
  if (!arguments.json.empty()) {
    reports::write_json(arguments.json, reports::count_json(info, results, options.li_format));
  }
  fmt::print("{}", reports::count_text(info, results));
  if (options.maps) {
    fmt::print("maps: {}\n",
               reports::to_text(reports::write_maps(arguments.maps, trace.view(), results.front(),
                                                    options.li_format)));
  }
  return reports::held(results) ? 0 : 1;
}

}  // namespace

Command add_count(CLI::App& program) {
  CLI::App* app =
      program.add_subcommand("count", "Count the memory accesses of a trace and check every pixel");
  auto arguments = std::make_shared<Arguments>();
  const auto add = [app](const char* name, std::string& value, const char* type,
                         const char* description) {
    app->add_option(name, value, description)->type_name(type)->capture_default_str();
  };
  app->add_option("FILE", arguments->file, "A trace")->required()->type_name("");
  add("--mode", arguments->mode, "SET", "single-pass, three-pass");
  add("--tile", arguments->tile, "SET", "Tile edges in pixels: 2, 4, ... 256, or all");
  add("--cull", arguments->cull, "SET",
      "Tests that skip tiles of faces: none, zmax, zrange, planes, both, sat");
  add("--umbra-cull", arguments->umbra_cull, "SET",
      "Tests that skip tiles of umbra polygons: none, zmax");
  add("--accept", arguments->accept, "SET",
      "Tests that write umbra polygons without reading depth: none, zmin");
  add("--share", arguments->share, "SET",
      "Umbra polygons that share their wedge's visit in single-pass: eye (facing it), all");
  add("--z", arguments->z, "auto|pass|fail", "z-pass, z-fail, or what the trace needs");
  add("--tile-build", arguments->tile_build, "eager|lazy|none",
      "When the tiles' zmin and zmax are made");
  add("--datapath", arguments->datapath, "exact|paper255",
      "Arithmetic of LI: rounded to 2^-40, or integers of 255 as in Papers I and II");
  add("--needs", arguments->needs, "all", "Casters that are counted");
  app->add_option("--json", arguments->json, "Write the results as JSON, too")->type_name("FILE");
  app->add_option("--maps", arguments->maps,
                  "Write maps of one configuration: PREFIX_z_reads, PREFIX_li_writes, PREFIX_li, "
                  "PREFIX_difference as .png and .exr")
      ->type_name("PREFIX");
  app->footer(
      "A SET is one value or several with commas; all combinations are counted.\n"
      "Example:\n  wedgesim count columns.wtrace --mode single-pass,three-pass --tile 4,8,16");
  return {app, [arguments] { return run(*arguments); }};
}

}  // namespace wedgesim::cli
