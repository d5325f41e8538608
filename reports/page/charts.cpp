#include <fmt/format.h>

#include <algorithm>

#include "reports/page/chart.h"
#include "reports/page/names.h"
#include "reports/page/unit_charts.h"

namespace wedgesim::reports::page {
namespace {

/// Makes charts of the columns that a study has, and leaves out the others.
class ChartMaker {
 public:
  explicit ChartMaker(const Columns& columns) : columns_(columns) {}

  std::vector<Chart> make() {
    by_tile();
    precision();
    error_over_bits();
    memory();
    scaling();
    errors_over_time();
    for (Chart& chart : unit_charts(columns_)) charts_.push_back(std::move(chart));
    for (const Plot& plot : columns_.results().study.plots) own(plot);
    return std::move(charts_);
  }

 private:
  void add(std::optional<Chart> chart) {
    if (!chart) return;
    const bool is_known = std::ranges::any_of(charts_, [&chart](const Chart& other) {
      return other.x == chart->x && other.series == chart->series &&
             std::ranges::equal(other.measures, chart->measures, {}, &Measure::column,
                                &Measure::column);
    });
    if (!is_known) charts_.push_back(*std::move(chart));
  }

  Chart chart_of(std::string id, std::string title, std::string about, const Column* x,
                 const Column* series, std::vector<Measure> measures) const {
    Chart chart;
    chart.id = std::move(id);
    chart.title = std::move(title);
    chart.about = std::move(about);
    chart.x = x;
    chart.series = series;
    chart.measures = std::move(measures);
    return chart;
  }

  // One metric by tile size, a line each for the modes.
  void lines_by_tile(const std::string& metric, const std::string& title,
                     const std::string& about) {
    const Column* column = columns_.number(metric);
    const Column* tile = columns_.axis("block.tile");
    if (column == nullptr || tile == nullptr) return;
    add(finish_lines(columns_, chart_of("tile-" + metric, title, about, tile,
                                        columns_.axis("block.mode"), {{column, column->label}})));
  }

  void by_tile() {
    lines_by_tile("z_reads", "Depth words read, by tile size",
                  "Words of depth that inside and umbra tests read in a frame (Paper II, fig. 7).");
    lines_by_tile("li_writes", "LI words written, by tile size",
                  "Words written to LI and the stencil in a frame.");
    lines_by_tile("accesses", "All accesses, by tile size", "Reads of depth and writes of LI.");
    lines_by_tile("all_bytes", "All traffic, by tile size",
                  "Bytes of everything: pixels, tile words, clears, merges, wedge records.");
    lines_by_tile("over_floor", "Accesses over the floor",
                  "1 is what no design can do without: each needed pixel once.");
    const Column* efficiency = columns_.number("cull_efficiency");
    const Column* tile = columns_.axis("block.tile");
    if (efficiency != nullptr && tile != nullptr) {
      add(finish_lines(
          columns_, chart_of("cull-efficiency", "Culling against a perfect cull",
                             "A perfect cull skips every visit in which no pixel is written.", tile,
                             columns_.axis("block.cull"), {{efficiency, efficiency->label}})));
    }
    lines_by_tile("frames_per_second", "Frames per second, by tile size",
                  "At the block's clock, memory included (Paper II, fig. 8).");
  }

  // Bits of each format whose width the study varies.
  void precision() {
    for (const Column* column : columns_.axes()) {
      if (!column->key.starts_with("formats.")) continue;
      for (const char* metric : {"max_error", "rms_error", "mismatched"}) {
        const Column* error = columns_.number(metric);
        if (error == nullptr || !error->varies()) continue;
        add(finish_lines(
            columns_, chart_of(fmt::format("{}-{}", metric, column->key),
                               fmt::format("{} against {}", capital(error->label), column->label),
                               "Against the double-precision LI of the trace.", column,
                               columns_.axis("block.mode"), {{error, error->label}})));
      }
    }
  }

  void error_over_bits() {
    const Column* bits = columns_.number("format_bits");
    const Column* error = columns_.number("max_error");
    if (bits == nullptr || error == nullptr) return;
    add(finish_dots(
        columns_,
        chart_of("error-bits", "Largest error against bits",
                 "All varied widths together, a measure of area. Left and low is better.", bits,
                 nullptr, {{error, error->label}}),
        false));
  }

  void memory() {
    for (const Column* column : columns_.axes()) {
      if (column->key.ends_with("cache_bytes")) hit_rates(column);
    }
    const Column* traffic = columns_.number("port_gb_per_second");
    for (const char* key : {"memory.dram.preset", "preset", "memory.kind"}) {
      if (traffic == nullptr || columns_.axis(key) == nullptr) continue;
      add(finish_bars(
          columns_,
          chart_of(fmt::format("traffic-{}", key), "Memory traffic, by memory",
                   "Bytes at the memory port in a second at the block's clock.", columns_.axis(key),
                   columns_.axis("block.mode"), {{traffic, traffic->label}})));
    }
  }

  void hit_rates(const Column* size) {
    std::vector<Measure> measures;
    for (const Column& column : columns_.all()) {
      if (!column.key.starts_with("cache.") || !column.key.ends_with(".hit_rate")) continue;
      if (!column.is_number() || !column.varies()) continue;
      measures.push_back({&column, column.key.substr(6, column.key.size() - 6 - 9)});
    }
    if (measures.empty()) return;
    add(finish_lines(columns_,
                     chart_of("hits-" + size->key, fmt::format("Hit rates against {}", size->label),
                              "The part of accesses that a cache answers itself.", size, nullptr,
                              std::move(measures))));
  }

  void scaling() {
    for (const char* key : {"pixels", "wedges"}) {
      if (auto chart = scaling_chart(columns_, key))
        add(finish_dots(columns_, *std::move(chart), true));
    }
  }

  void errors_over_time() {
    const Column* time = columns_.number("run_seconds");
    const Column* error = columns_.number("rms_error");
    if (time == nullptr || error == nullptr || !error->varies()) return;
    add(finish_dots(columns_,
                    chart_of("error-time", "Error against run time",
                             "Seconds of one core to count a frame. Left and low is better.", time,
                             columns_.axis("datapath"), {{error, error->label}}),
                    false));
  }

  void own(const Plot& plot) {
    const Column* x = columns_.find(plot.x == "width" || plot.x == "height" ? "size" : plot.x);
    const Column* y = columns_.number(plot.y);
    if (x == nullptr || y == nullptr) return;
    Chart chart = chart_of(fmt::format("own-{}", charts_.size()), plot.title, "", x,
                           columns_.find(plot.series), {{y, y->label}});
    if (plot.kind == "scatter" && x->is_number()) {
      add(finish_dots(columns_, std::move(chart), false));
    } else if (plot.kind == "bar") {
      add(finish_bars(columns_, std::move(chart)));
    } else {
      add(finish_lines(columns_, std::move(chart)));
    }
  }

  const Columns& columns_;
  std::vector<Chart> charts_;
};

}  // namespace

std::optional<Chart> scaling_chart(const Columns& columns, std::string_view key) {
  const bool pixels = key == "pixels";
  const Column* cost = columns.number("cycles");
  if (cost == nullptr) cost = columns.number("accesses");
  const Column* x = columns.number(key);
  // Less says little of a slope: it may come from what else differs between frames.
  const double least_range = pixels ? 10.0 : 100.0;
  if (cost == nullptr || x == nullptr || x->range() < least_range) return std::nullopt;
  if (pixels && columns.axis("size") == nullptr) return std::nullopt;
  Chart chart;
  chart.id = fmt::format("scaling-{}", key);
  chart.title = pixels ? "Cost over resolution" : "Cost over silhouette edges";
  chart.about = "Both axes logarithmic; dashed: the fitted power.";
  chart.x = x;
  chart.series = columns.axis("block.mode");
  chart.measures = {{cost, cost->label}};
  chart.held = choose_held(columns, chart);
  return chart;
}

std::vector<Chart> make_charts(const Columns& columns) { return ChartMaker(columns).make(); }

}  // namespace wedgesim::reports::page
