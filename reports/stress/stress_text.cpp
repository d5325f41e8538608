#include "reports/stress/stress_text.h"

#include <fmt/format.h>

#include "reports/stress/case_name.h"
#include "reports/stress/levels.h"
#include "reports/table.h"

namespace wedgesim::reports::stress {
namespace {

std::string level_text(const std::optional<double>& level) {
  return level ? difficulty_text(*level) : "-";
}

}  // namespace

std::string levels_text(const FamilyResult& result) {
  using Align = Table::Align;
  Table table;
  table.add_column(std::string(result.family->unit.empty() ? "difficulty" : result.family->unit),
                   Align::right);
  table.add_column("condition", Align::right);
  table.add_column("refused", Align::right);
  table.add_column("in penumbra", Align::right);
  for (const Arithmetic a : kArithmetics) {
    table.add_column("error", Align::right, std::string(name_of(a)));
    table.add_column("excess", Align::right);
    table.add_column("RMS", Align::right);
    table.add_column("beyond", Align::right);
    table.add_column("specks", Align::right);
    table.add_column("leaks", Align::right);
    table.add_column("jump", Align::right);
  }
  for (std::size_t i = 0; i < result.levels.size(); ++i) {
    const auto& seeds = result.levels[i];
    std::size_t refused = 0;
    std::size_t in_penumbra = 0;
    for (const Measurement& m : seeds) {
      refused += m.refused ? 1 : 0;
      in_penumbra += m.in_penumbra;
    }
    std::vector<std::string> row{difficulty_text(result.family->levels[i]),
                                 fmt::format("{:.1e}", condition_of(seeds)),
                                 std::to_string(refused), std::to_string(in_penumbra)};
    for (const Arithmetic a : kArithmetics) {
      const Errors worst = worst_of(seeds, a);
      row.push_back(fmt::format("{:.1e}", worst.max_error));
      row.push_back(fmt::format("{:.1e}", worst.max_excess));
      row.push_back(fmt::format("{:.1e}", worst.rms));
      row.push_back(std::to_string(worst.beyond));
      row.push_back(std::to_string(worst.specks));
      row.push_back(std::to_string(worst.leaks));
      row.push_back(worst.jump ? fmt::format("{:.1e}", worst.jump->excess) : "-");
    }
    table.add_row(std::move(row));
  }
  return fmt::format("{}: {}\n{}", result.family->name, result.family->parameter, table.text(2));
}

std::string stress_text(const std::vector<FamilyResult>& results) {
  using Align = Table::Align;
  Table table;
  table.add_column("family", Align::left);
  table.add_column("harmless", Align::right);
  table.add_column("fixed", Align::right, "must hold to");
  table.add_column("double", Align::right);
  bool first = true;
  for (const Arithmetic a : kArithmetics) {
    table.add_column(std::string(name_of(a)), Align::right, first ? "holds to" : "");
    first = false;
  }
  table.add_column("", Align::left);
  std::size_t wrong = 0;
  std::string complaints;
  for (const FamilyResult& result : results) {
    std::vector<std::string> row{std::string(result.family->name),
                                 difficulty_text(result.family->levels.front()),
                                 level_text(result.required(Arithmetic::fixed)),
                                 level_text(result.required(Arithmetic::double_precision))};
    for (const Arithmetic a : kArithmetics) row.push_back(level_text(result.holds_to(a)));
    const auto problems = result.complaints();
    row.emplace_back(problems.empty() ? "held" : "NOT held");
    table.add_row(std::move(row));
    wrong += problems.empty() ? 0 : 1;
    for (const std::string& problem : problems) {
      complaints += fmt::format("{}: {}\n", result.family->name, problem);
    }
  }
  return fmt::format("{}\n{}{} of {} families are as they must be\n", table.text(), complaints,
                     results.size() - wrong, results.size());
}

}  // namespace wedgesim::reports::stress
