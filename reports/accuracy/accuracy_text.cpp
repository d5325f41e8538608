#include "reports/accuracy/accuracy_text.h"

#include <fmt/format.h>

#include <algorithm>

#include "reports/accuracy/accuracy_table.h"
#include "reports/table.h"

namespace wedgesim::reports::accuracy {
namespace {

Table new_table() {
  using Align = Table::Align;
  Table table;
  for (const Column& column : columns()) {
    table.add_column(std::string(column.name), column.number ? Align::right : Align::left,
                     std::string(column.group));
  }
  return table;
}

}  // namespace

std::string accuracy_text(const SceneResult& result, const Wish* wish) {
  std::string text =
      fmt::format("{}, frame {}: {}\n", result.scene.name, result.scene.frame, facts_of(result));
  const std::vector<std::size_t> front = pareto_front(result.methods);
  Table table = new_table();
  std::string refused;
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    const Measured& measured = result.methods[i];
    if (measured.refused) {
      refused += fmt::format("  {} refused: {}\n", measured.choice.text, *measured.refused);
      continue;
    }
    table.add_row(cells_of(measured, std::ranges::find(front, i) != front.end()));
  }
  text += table.text(2) + "  * no other is both faster and more exact\n" + refused;
  if (wish != nullptr) {
    const Recommendation found = recommend(result.methods, *wish);
    text += fmt::format("  {}: {}\n", found.method ? "recommended" : "none", found.why);
  }
  return text;
}

}  // namespace wedgesim::reports::accuracy
