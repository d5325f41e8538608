#include "reports/runner/savings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/runner/counted.h"
#include "reports/runner/spread.h"

namespace wedgesim::reports {
namespace {

using model::Accept;
using model::CountConfig;
using model::Mode;
using model::Share;

struct Comparison {
  const char* name;
  Accept three_pass;
  Accept single_pass;
  Share share;
};

constexpr Comparison kComparisons[] = {
    {"neither accepts", Accept::none, Accept::none, Share::eye},
    {"neither accepts, share all", Accept::none, Accept::none, Share::all},
    {"both accept zmin", Accept::zmin, Accept::zmin, Share::eye},
    {"both accept zmin, share all", Accept::zmin, Accept::zmin, Share::all},
    {"single-pass alone accepts zmin", Accept::none, Accept::zmin, Share::eye},
};

struct Savings {
  std::vector<double> reads, writes;  // per cent, one a scene and tile size
};

Savings savings_of(const Results& results, const CountedPoints& points,
                   const Comparison& comparison) {
  Savings savings;
  CountConfig three;
  three.mode = Mode::three_pass;
  three.accept = comparison.three_pass;
  CountConfig single;
  single.mode = Mode::single_pass;
  single.accept = comparison.single_pass;
  single.share = comparison.share;
  for (const FrameRow& frame : results.frames) {
    for (const unsigned tile : points.tiles()) {
      three.tile = single.tile = tile;
      const PointRow* from = points.find(frame.label, three);
      const PointRow* to = points.find(frame.label, single);
      if (from == nullptr || to == nullptr) continue;
      const Accesses a = accesses_of(*from);
      const Accesses b = accesses_of(*to);
      if (const auto saved = saved_percent(a.reads, b.reads)) savings.reads.push_back(*saved);
      if (const auto saved = saved_percent(a.writes, b.writes)) savings.writes.push_back(*saved);
    }
  }
  return savings;
}

// Least, median, most; blanks without values.
void append_spread(std::vector<std::string>& cells, std::vector<double> values) {
  if (values.empty()) {
    cells.insert(cells.end(), 3, "-");
    return;
  }
  std::ranges::sort(values);
  for (const double value : {values.front(), quantile(values, 0.5), values.back()}) {
    cells.push_back(fmt::format("{:.1f}", value));
  }
}

}  // namespace

Document savings_text(const Results& results) {
  const CountedPoints points(results);
  Table table;
  table.add_column("", Table::Align::left);
  for (const char* group : {"z reads saved %", "LI writes saved %"}) {
    table.add_column("least", Table::Align::right, group);
    table.add_column("median", Table::Align::right);
    table.add_column("most", Table::Align::right);
  }
  bool any = false;
  for (const Comparison& comparison : kComparisons) {
    const Savings savings = savings_of(results, points, comparison);
    if (savings.reads.empty() && savings.writes.empty()) continue;
    any = true;
    std::vector<std::string> cells{comparison.name};
    append_spread(cells, savings.reads);
    append_spread(cells, savings.writes);
    table.add_row(std::move(cells));
  }
  Document document;
  if (!any) return document;
  table.add_row({"Paper II claims", "30", "", "60", "", "5", ""});
  document.heading("What single-pass saves against three-pass, over all scenes and tile sizes");
  document.table(std::move(table));
  return document;
}

}  // namespace wedgesim::reports
