#include "cli/count_arguments.h"

#include <fmt/format.h>

#include <algorithm>
#include <iterator>

#include "cli/parse.h"
#include "reports/sweep.h"

namespace wedgesim::cli {
namespace {

template <typename E>
std::vector<E> parse_choices(std::string_view option, std::string_view text) {
  return parse_set(option, text,
                   [option](std::string_view part) { return model::parse<E>(option, part); });
}

std::vector<unsigned> parse_tiles(std::string_view text) {
  if (text == "all") return reports::all_tiles();
  return parse_set("--tile", text, [](std::string_view part) {
    if (part == "all") throw InputError("--tile", "'all' stands beside other values", "it alone");
    return model::parse_tile("--tile", part);
  });
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
  sweep.modes = parse_choices<model::Mode>("--mode", mode);
  sweep.tiles = parse_tiles(tile);
  sweep.culls = parse_choices<model::Cull>("--cull", cull);
  sweep.umbra_culls = parse_choices<model::UmbraCull>("--umbra-cull", umbra_cull);
  sweep.accepts = parse_choices<model::Accept>("--accept", accept);
  sweep.shares = parse_choices<model::Share>("--share", share);
  sweep.z = model::parse<model::ZChoice>("--z", z);
  sweep.tile_build = model::parse<model::TileBuild>("--tile-build", tile_build);
  return sweep.configs();
}

model::CountConfig CountArguments::single_config() const {
  const std::vector<model::CountConfig> all = configs();
  if (all.size() == 1) return all.front();
  const std::pair<std::string_view, std::string_view> sets[] = {
      {"--mode", mode},     {"--cull", cull},   {"--umbra-cull", umbra_cull},
      {"--accept", accept}, {"--share", share}, {"--tile", tile}};
  const auto* several = std::ranges::find_if(
      sets, [](const auto& set) { return set.second.find(',') != std::string_view::npos; });
  const auto& [option, text] = several == std::end(sets) ? sets[5] : *several;  // --tile all
  throw InputError(option, fmt::format("'{}' is more than one value", text), "one value");
}

}  // namespace wedgesim::cli
