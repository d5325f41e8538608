#include "cli/count_arguments.h"

#include <fmt/format.h>

#include "cli/parse.h"
#include "reports/sweep.h"

namespace wedgesim::cli {
namespace {

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

}  // namespace

void CountArguments::add_to(CLI::App& app) {
  const auto add = [&app](const char* name, std::string& value, const char* type,
                          const char* description) {
    app.add_option(name, value, description)->type_name(type)->capture_default_str();
  };
  add("--mode", mode, "SET", "single-pass, three-pass");
  add("--tile", tile, "SET", "Tile edges in pixels: 2, 4, ... 256, or all");
  add("--cull", cull, "SET",
      "Tests that skip tiles of faces: none, zmax, zrange, planes, both, sat");
  add("--umbra-cull", umbra_cull, "SET", "Tests that skip tiles of umbra polygons: none, zmax");
  add("--accept", accept, "SET",
      "Tests that write umbra polygons without reading depth: none, zmin");
  add("--share", share, "SET",
      "Umbra polygons that share their wedge's visit in single-pass: eye (facing it), all");
  add("--z", z, "auto|pass|fail", "z-pass, z-fail, or what the trace needs");
  add("--tile-build", tile_build, "eager|lazy|none", "When the tiles' zmin and zmax are made");
}

std::vector<model::CountConfig> CountArguments::configs() const {
  reports::Sweep sweep;
  sweep.modes = parse_set<model::Mode>("--mode", mode);
  sweep.tiles = parse_tiles(tile);
  sweep.culls = parse_set<model::Cull>("--cull", cull);
  sweep.umbra_culls = parse_set<model::UmbraCull>("--umbra-cull", umbra_cull);
  sweep.accepts = parse_set<model::Accept>("--accept", accept);
  sweep.shares = parse_set<model::Share>("--share", share);
  sweep.z = model::parse<model::ZChoice>("--z", z);
  sweep.tile_build = model::parse<model::TileBuild>("--tile-build", tile_build);
  return sweep.configs();
}

model::CountConfig CountArguments::single_config() const {
  const std::vector<model::CountConfig> all = configs();
  if (all.size() != 1) {
    throw InputError("configuration", fmt::format("{} are given", all.size()),
                     "one value of each option");
  }
  return all.front();
}

}  // namespace wedgesim::cli
