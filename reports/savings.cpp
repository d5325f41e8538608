#include "reports/savings.h"

#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "reports/accesses.h"
#include "reports/table.h"

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

Savings savings_of(const StudyResults& results, const Comparison& comparison) {
  Savings savings;
  CountConfig three = results.study.pictured;
  three.mode = Mode::three_pass;
  three.accept = comparison.three_pass;
  CountConfig single = results.study.pictured;
  single.mode = Mode::single_pass;
  single.accept = comparison.single_pass;
  single.share = comparison.share;
  for (const SceneResults& scene : results.scenes) {
    for (const unsigned tile : tiles_of(results.study)) {
      three.tile = single.tile = tile;
      const auto* from = find(scene, three);
      const auto* to = find(scene, single);
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
  const std::size_t half = values.size() / 2;
  const double median =
      values.size() % 2 == 1 ? values[half] : 0.5 * (values[half - 1] + values[half]);
  for (const double value : {values.front(), median, values.back()}) {
    cells.push_back(fmt::format("{:.1f}", value));
  }
}

}  // namespace

std::string savings_text(const StudyResults& results) {
  Table table;
  table.add_column("", Table::Align::left);
  for (const char* group : {"z reads saved %", "LI writes saved %"}) {
    table.add_column("least", Table::Align::right, group);
    table.add_column("median", Table::Align::right);
    table.add_column("most", Table::Align::right);
  }
  bool any = false;
  for (const Comparison& comparison : kComparisons) {
    const Savings savings = savings_of(results, comparison);
    if (savings.reads.empty() && savings.writes.empty()) continue;
    any = true;
    std::vector<std::string> cells{comparison.name};
    append_spread(cells, savings.reads);
    append_spread(cells, savings.writes);
    table.add_row(std::move(cells));
  }
  if (!any) return {};
  table.add_row({"Paper II claims", "30", "", "60", "", "5", ""});
  return "What single-pass saves against three-pass, over all scenes and tile sizes\n\n" +
         table.text(2);
}

}  // namespace wedgesim::reports
