#include "reports/runner/modes_text.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <array>
#include <optional>
#include <vector>

#include "reports/runner/counted.h"
#include "reports/runner/savings.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

using model::CountConfig;
using model::Mode;

constexpr std::array<std::uint64_t, 4> kVisitCosts{0, 1, 2, 4};  // accesses a tile visit
const CountConfig kShown;

std::string thousands(std::uint64_t accesses) {
  return fmt::format("{:.1f}", static_cast<double>(accesses) / 1000.0);
}

std::string saved(std::uint64_t from, std::uint64_t to) {
  const std::optional<double> percent = saved_percent(from, to);
  return percent ? fmt::format("{:.1f}", *percent) : "-";
}

std::uint64_t whole(const PointRow& point, std::string_view metric) {
  return static_cast<std::uint64_t>(number_of(find_value(point.metrics, metric)).value_or(0.0));
}

std::string ratio(const PointRow& point) {
  const std::optional<double> over = number_of(find_value(point.metrics, "over_floor"));
  return over ? fmt::format("{:.2f}", *over) : "-";
}

std::string megabytes(const PointRow& point) {
  return fmt::format("{:.2f}", static_cast<double>(whole(point, "all_bytes")) / 1e6);
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
void add_accesses(Table& table, std::vector<std::string> cells, const CountedPoints& points,
                  const std::string& frame, CountConfig config) {
  config.mode = Mode::single_pass;
  const PointRow* single = points.find(frame, config);
  config.mode = Mode::three_pass;
  config.share = model::Share::eye;
  const PointRow* three = points.find(frame, config);
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
Table tile_table(const CountedPoints& points, const std::string& frame) {
  Table table;
  table.add_column("tile", Table::Align::right);
  add_access_columns(table);
  CountConfig config = kShown;
  for (const unsigned tile : points.tiles()) {
    config.tile = tile;
    add_accesses(table, {std::to_string(tile)}, points, frame, config);
  }
  table.add_rule();
  const PointRow& any = *points.of(frame).front();
  const std::uint64_t reads = whole(any, "z_reads_floor");
  const std::uint64_t writes = whole(any, "li_writes_floor");
  table.add_row({"floor", thousands(reads), thousands(writes), thousands(reads + writes)});
  return table;
}

template <typename E>
E option(const PointRow& point, const char* key) {
  return model::parse<E>(key, to_text(find_value(point.configuration, key)));
}

// Accesses by culling and acceptance tests, at one tile size.
Table culling_table(const CountedPoints& points, const std::string& frame) {
  Table table;
  for (const char* title : {"cull", "umbra", "accept", "share"}) {
    table.add_column(title, Table::Align::left);
  }
  add_access_columns(table);
  for (const PointRow* point : points.of(frame)) {
    CountConfig config = kShown;
    config.cull = option<model::Cull>(*point, "block.cull");
    config.umbra_cull = option<model::UmbraCull>(*point, "block.umbra_cull");
    config.accept = option<model::Accept>(*point, "block.accept");
    config.share = option<model::Share>(*point, "block.share");
    if (points.find(frame, config) != point) continue;  // another tile or mode
    add_accesses(table,
                 {std::string(spelling(config.cull)), std::string(spelling(config.umbra_cull)),
                  std::string(spelling(config.accept)), std::string(spelling(config.share))},
                 points, frame, config);
  }
  return table;
}

std::string best_tiles(const CountedPoints& points, const std::string& frame) {
  const auto sizes = [&](Mode mode) {
    CountConfig config = kShown;
    config.mode = mode;
    std::array<unsigned, kVisitCosts.size()> tiles{};
    for (std::size_t i = 0; i < tiles.size(); ++i) {
      tiles[i] = points.best_tile(frame, config, kVisitCosts[i]);
    }
    return fmt::format("{}", fmt::join(tiles, ", "));
  };
  return fmt::format("best tile at {} accesses a tile visit: three-pass {}; single-pass {}",
                     fmt::join(kVisitCosts, ", "), sizes(Mode::three_pass),
                     sizes(Mode::single_pass));
}

void add_frame(Document& document, const CountedPoints& points, const FrameRow& frame) {
  if (points.of(frame.label).empty()) return;
  document.heading(fmt::format("{}: {}x{} pixels, {} wedges, z-{}", frame.label,
                               to_text(find_value(frame.parameters, "width")),
                               to_text(find_value(frame.parameters, "height")),
                               grouped(static_cast<std::uint64_t>(frame.wedges)),
                               to_text(find_value(points.of(frame.label).front()->metrics, "z"))));
  document.paragraph(
      fmt::format("accesses in thousands by tile size (cull {}, umbra cull {}, accept {})",
                  spelling(kShown.cull), spelling(kShown.umbra_cull), spelling(kShown.accept)));
  document.table(tile_table(points, frame.label));
  document.paragraph(fmt::format("by culling test at tile {}", kShown.tile));
  document.table(culling_table(points, frame.label));
  std::string notes = best_tiles(points, frame.label) + '\n' + pixels_text(points.of(frame.label));
  if (!frame.pictures.empty()) {
    notes += fmt::format("\npictures of {}, tile {}: {}", spelling(kShown.mode), kShown.tile,
                         frame.pictures);
  }
  document.paragraph(notes);
}

}  // namespace

Document modes_text(const Results& results) {
  const CountedPoints points(results);
  Document document;
  for (const FrameRow& frame : results.frames) add_frame(document, points, frame);
  document.append(savings_text(results));
  return document;
}

}  // namespace wedgesim::reports
