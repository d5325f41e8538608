#include "reports/count_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <optional>

#include "reports/accesses.h"
#include "reports/table.h"

namespace wedgesim::reports {
namespace {

using model::CountConfig;
using model::CountResult;

constexpr std::size_t kSideBySide = 4;

bool held(const CountResult& result) {
  return result.pixels.mismatched == 0 && result.wrong_contributions == 0;
}

std::string label(const CountResult& result) {
  const CountConfig& config = result.config;
  return fmt::format("{}, tile {}, cull {}, umbra cull {}, accept {}, share {}, z-{}",
                     spelling(config.mode), config.tile, spelling(config.cull),
                     spelling(config.umbra_cull), spelling(config.accept), spelling(config.share),
                     result.z == model::ZMethod::pass ? "pass" : "fail");
}

using Cell = std::function<std::string(const CountResult&)>;

std::vector<std::string> row(std::string name, std::span<const CountResult> results,
                             const Cell& cell) {
  std::vector<std::string> cells{std::move(name)};
  for (const CountResult& result : results) cells.push_back(cell(result));
  return cells;
}

void add_configuration(Table& table, std::span<const CountResult> results) {
  const std::pair<const char*, Cell> rows[] = {
      {"tile", [](const auto& r) { return std::to_string(r.config.tile); }},
      {"cull", [](const auto& r) { return std::string(spelling(r.config.cull)); }},
      {"umbra cull", [](const auto& r) { return std::string(spelling(r.config.umbra_cull)); }},
      {"accept", [](const auto& r) { return std::string(spelling(r.config.accept)); }},
      {"share", [](const auto& r) { return std::string(spelling(r.config.share)); }},
      {"z", [](const auto& r) { return r.z == model::ZMethod::pass ? "pass" : "fail"; }}};
  for (const auto& [name, cell] : rows) table.add_row(row(name, results, cell));
}

void add_counters(Table& table, std::span<const CountResult> results) {
  const auto& registry = results.front().counters->counters();
  for (std::size_t i = 0; i < registry.size(); ++i) {
    auto cells = row(std::string(registry[i]->name()), results, [i](const CountResult& result) {
      return grouped(result.counters->counters()[i]->value());
    });
    cells.emplace_back(name_of(registry[i]->unit()));
    cells.emplace_back(registry[i]->description());
    table.add_row(std::move(cells));
  }
}

// Paper II's totals; all_bytes, which holds everything else too, is a counter.
void add_totals(Table& table, std::span<const CountResult> results) {
  auto total =
      row("accesses", results, [](const auto& r) { return grouped(accesses_of(r).total()); });
  total.insert(total.end(), {"accesses", "z_reads + li_writes"});
  table.add_row(std::move(total));
  auto ratio = row("accesses / floor", results, [](const auto& r) {
    const std::optional<double> over = over_floor(r);
    return over ? fmt::format("{:.2f}", *over) : "-";
  });
  ratio.insert(ratio.end(), {"", "floor: z_reads_floor + li_writes_floor"});
  table.add_row(std::move(ratio));
}

}  // namespace

bool held(std::span<const CountResult> results) {
  return std::ranges::all_of(results, [](const CountResult& result) { return held(result); });
}

std::string count_text(const TraceInfo& trace, std::span<const CountResult> results) {
  std::string text = fmt::format("{}: {}x{}, {} wedges, checksum {:016x}\n\n", trace.name,
                                 trace.width, trace.height, trace.wedges, trace.checksum);
  for (std::size_t first = 0; first < results.size(); first += kSideBySide) {
    const auto some = results.subspan(first, std::min(kSideBySide, results.size() - first));
    Table table;
    table.add_column("mode", Table::Align::left);
    for (const CountResult& result : some) {
      table.add_column(std::string(spelling(result.config.mode)), Table::Align::right);
    }
    table.add_column("unit", Table::Align::left);
    table.add_column("", Table::Align::left);
    add_configuration(table, some);
    table.add_rule();
    add_counters(table, some);
    table.add_rule();
    add_totals(table, some);
    text += table.text() + '\n';
  }
  const auto failed = std::ranges::find_if_not(results, [](const auto& r) { return held(r); });
  const CountResult& shown = failed == results.end() ? results.front() : *failed;
  return text + pixels_text(results) + worst_pixels_text(shown.pixels);
}

std::string pixels_text(std::span<const CountResult> results) {
  double max_error = 0.0, rms_error = 0.0;
  std::uint64_t mismatched = 0, wrong = 0;
  for (const CountResult& result : results) {
    max_error = std::max(max_error, result.pixels.max_error);
    rms_error = std::max(rms_error, result.pixels.rms_error);
    mismatched += result.pixels.mismatched;
    wrong += result.wrong_contributions;
  }
  const model::PixelCheck& first = results.front().pixels;
  const std::string configurations =
      results.size() == 1 ? "1 configuration" : fmt::format("{} configurations", results.size());
  if (first.compared == 0) {
    return fmt::format("pixels: none compared, the trace holds no expected LI; {}\n",
                       configurations);
  }
  std::string text = fmt::format(
      "pixels: {} compared in {}; max error {:.2g}, RMS {:.2g}, {} mismatched (tolerance {:g} "
      "plus sensitivity)\n",
      grouped(first.compared), configurations, max_error, rms_error, grouped(mismatched),
      first.tolerance);
  for (const CountResult& result : results) {
    if (!result.first_overflow) continue;
    text += fmt::format("OVERFLOW: {}: {} pixels, first {},{}\n", label(result),
                        grouped(result.counters->li_overflow_pixels.value()),
                        (*result.first_overflow)[0], (*result.first_overflow)[1]);
  }
  if (wrong > 0) text += fmt::format("tile tests lost {} contributions\n", grouped(wrong));
  for (const CountResult& result : results) {
    if (held(result)) continue;
    text += fmt::format("FAILED: {}: {} pixels mismatched, {} contributions lost\n", label(result),
                        grouped(result.pixels.mismatched), grouped(result.wrong_contributions));
  }
  return text;
}

std::string flags_text(std::span<const model::WedgeFlag> flagged) {
  if (flagged.empty()) return {};
  const model::WedgeFlag& worst = *std::ranges::max_element(flagged, {}, &model::WedgeFlag::value);
  return fmt::format("{} wedges flagged: {} at worst, {:.2g} times farther than allowed: {}\n",
                     grouped(flagged.size()), worst.wedge, worst.value, describe(worst.reason));
}

std::string worst_pixels_text(const model::PixelCheck& pixels) {
  if (pixels.worst.empty()) return {};
  Table table;
  for (const char* title : {"x", "y", "expected", "li", "error", "sensitivity"}) {
    table.add_column(title, Table::Align::right);
  }
  for (const model::PixelError& pixel : pixels.worst) {
    table.add_row({std::to_string(pixel.x), std::to_string(pixel.y),
                   fmt::format("{:.9f}", pixel.expected), fmt::format("{:.9f}", pixel.li),
                   fmt::format("{:.3g}", pixel.error), fmt::format("{:.3g}", pixel.sensitivity)});
  }
  return fmt::format("the {} worst pixels:\n", pixels.worst.size()) + table.text(2);
}

}  // namespace wedgesim::reports
