#include "reports/study_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <vector>

#include "reports/accesses.h"
#include "reports/count_text.h"
#include "reports/savings.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

using model::CountConfig;
using model::CountResult;
using model::Mode;

constexpr std::array<std::uint64_t, 4> kVisitCosts{0, 1, 2, 4};  // accesses a tile visit

std::string thousands(std::uint64_t accesses) {
  return fmt::format("{:.1f}", static_cast<double>(accesses) / 1000.0);
}

std::string saved(std::uint64_t from, std::uint64_t to) {
  const std::optional<double> percent = saved_percent(from, to);
  return percent ? fmt::format("{:.1f}", *percent) : "-";
}

std::string ratio(const CountResult& result) {
  const std::optional<double> over = over_floor(result);
  return over ? fmt::format("{:.2f}", *over) : "-";
}

std::string megabytes(const CountResult& result) {
  return fmt::format("{:.2f}", static_cast<double>(result.counters->all_bytes.value()) / 1e6);
}

void add_access_columns(Table& table) {
  for (const char* mode : {"three-pass", "single-pass"}) {
    table.add_column("z reads", Table::Align::right, mode);
    table.add_column("LI writes", Table::Align::right);
    table.add_column("total", Table::Align::right);
  }
  table.add_column("reads", Table::Align::right, "single-pass saves %");
  table.add_column("writes", Table::Align::right);
  table.add_column("total", Table::Align::right);
  for (const char* group : {"total / floor", "all_bytes, MB"}) {
    table.add_column("three", Table::Align::right, group);
    table.add_column("single", Table::Align::right);
  }
}

// Both modes of one configuration beside each other; three-pass without what it does not know.
void add_accesses(Table& table, std::vector<std::string> cells, const SceneResults& scene,
                  CountConfig config) {
  config.mode = Mode::single_pass;
  const CountResult* single = find(scene, config);
  config.mode = Mode::three_pass;
  config.share = model::Share::eye;
  const CountResult* three = find(scene, config);
  if (single == nullptr || three == nullptr) return;
  const Accesses a = accesses_of(*three);
  const Accesses b = accesses_of(*single);
  for (const Accesses& mode : {a, b}) {
    for (const std::uint64_t number : {mode.reads, mode.writes, mode.total()}) {
      cells.push_back(thousands(number));
    }
  }
  cells.push_back(saved(a.reads, b.reads));
  cells.push_back(saved(a.writes, b.writes));
  cells.push_back(saved(a.total(), b.total()));
  cells.insert(cells.end(), {ratio(*three), ratio(*single), megabytes(*three), megabytes(*single)});
  table.add_row(std::move(cells));
}

// Accesses by tile size, and the floor.
std::string tile_table(const StudyResults& results, const SceneResults& scene) {
  Table table;
  table.add_column("tile", Table::Align::right);
  add_access_columns(table);
  CountConfig config = results.study.pictured;
  for (const unsigned tile : tiles_of(results.study)) {
    config.tile = tile;
    add_accesses(table, {std::to_string(tile)}, scene, config);
  }
  table.add_rule();
  const model::Counters& floors = *scene.results.front().counters;
  const std::uint64_t reads = floors.z_reads_floor.value();
  const std::uint64_t writes = floors.li_writes_floor.value();
  table.add_row({"floor", thousands(reads), thousands(writes), thousands(reads + writes)});
  return table.text(2);
}

// Accesses by culling and acceptance tests, at one tile size.
std::string culling_table(const StudyResults& results, const SceneResults& scene) {
  Table table;
  for (const char* option : {"cull", "umbra", "accept", "share"}) {
    table.add_column(option, Table::Align::left);
  }
  add_access_columns(table);
  for (const CountConfig& config : results.study.configs) {
    if (config.tile != results.study.pictured.tile || config.mode != Mode::single_pass) continue;
    add_accesses(table,
                 {std::string(spelling(config.cull)), std::string(spelling(config.umbra_cull)),
                  std::string(spelling(config.accept)), std::string(spelling(config.share))},
                 scene, config);
  }
  return table.text(2);
}

std::string best_tiles(const StudyResults& results, const SceneResults& scene) {
  const auto sizes = [&](Mode mode) {
    CountConfig config = results.study.pictured;
    config.mode = mode;
    std::array<unsigned, kVisitCosts.size()> tiles{};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      tiles[i] = best_tile(results, scene, config, kVisitCosts[i]);
    }
    return fmt::format("{}", fmt::join(tiles, ", "));
  };
  return fmt::format("best tile at {} accesses a tile visit: three-pass {}; single-pass {}\n",
                     fmt::join(kVisitCosts, ", "), sizes(Mode::three_pass),
                     sizes(Mode::single_pass));
}

std::string scene_text(const StudyResults& results, const SceneResults& scene) {
  if (!scene.failure.empty()) return fmt::format("{}: left out: {}\n", scene.scene, scene.failure);
  const CountConfig& shown = results.study.pictured;
  std::string text = fmt::format("{}: {}x{} pixels, {} wedges, z-{}\n\n", scene.scene,
                                 scene.trace.width, scene.trace.height, grouped(scene.trace.wedges),
                                 scene.results.front().z == model::ZMethod::pass ? "pass" : "fail");
  text +=
      fmt::format("  accesses in thousands by tile size (cull {}, umbra cull {}, accept {})\n\n",
                  spelling(shown.cull), spelling(shown.umbra_cull), spelling(shown.accept));
  text += tile_table(results, scene);
  text += fmt::format("\n  by culling test at tile {}\n\n", shown.tile);
  text += culling_table(results, scene);
  text += "\n  " + best_tiles(results, scene);
  text += "  " + pixels_text(scene.results);
  text += fmt::format("  pictures of {}, tile {}: {}\n", spelling(shown.mode), shown.tile,
                      to_text(scene.scales));
  return text;
}

}  // namespace

std::string study_text(const StudyResults& results) {
  std::string text;
  for (const SceneResults& scene : results.scenes) {
    if (!text.empty()) text += '\n';
    text += scene_text(results, scene);
  }
  const std::string savings = savings_text(results);
  if (!savings.empty()) text += '\n' + savings;
  return text;
}

}  // namespace wedgesim::reports
