#include "reports/accuracy/accuracy_text.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "reports/table.h"

namespace wedgesim::reports::accuracy {
namespace {

std::string number(double value, int digits, const Errors& errors) {
  if (errors.values == 0) return "-";
  if (!std::isfinite(value)) return "inf";
  return fmt::format("{:.{}f}", value, digits);
}

Table new_table() {
  using Align = Table::Align;
  Table table;
  table.add_column("", Align::left);
  table.add_column("method", Align::left);
  table.add_column("RMSE", Align::right, "receivers");
  table.add_column("max", Align::right);
  table.add_column("PSNR", Align::right);
  table.add_column(">1/255 %", Align::right);
  table.add_column(">16/255 %", Align::right);
  table.add_column("casters", Align::right, "RMSE");
  table.add_column("penumbra", Align::right);
  table.add_column("1 thread", Align::right, "ms");
  table.add_column("all", Align::right);
  table.add_column("z reads", Align::right, "thousands");
  table.add_column("LI writes", Align::right);
  table.add_column("map writes", Align::right);
  table.add_column("MB", Align::right, "traffic");
  table.add_column("MB", Align::right, "memory");
  return table;
}

std::string thousands(std::uint64_t count) { return grouped((count + 500) / 1000); }

std::vector<std::string> row_of(const Measured& measured, bool on_front) {
  const Errors& receivers = measured.on(Region::receivers);
  const Errors& casters = measured.on(Region::casters);
  const Errors& penumbra = measured.on(Region::penumbra);
  return {on_front ? "*" : "",
          measured.choice.text,
          number(receivers.rmse, 4, receivers),
          number(receivers.largest, 3, receivers),
          number(receivers.psnr_db(), 1, receivers),
          number(100.0 * receivers.beyond_1_255, 2, receivers),
          number(100.0 * receivers.beyond_16_255, 2, receivers),
          number(casters.rmse, 4, casters),
          number(penumbra.rmse, 4, penumbra),
          fmt::format("{:.1f}", 1e3 * measured.timing.one_thread),
          fmt::format("{:.1f}", 1e3 * measured.timing.all_threads),
          thousands(measured.accesses.z_reads),
          thousands(measured.accesses.li_writes),
          thousands(measured.accesses.map_writes),
          fmt::format("{:.1f}", 1e-6 * static_cast<double>(measured.accesses.bytes)),
          fmt::format("{:.0f}", 1e-6 * static_cast<double>(measured.timing.peak_bytes))};
}

}  // namespace

std::string accuracy_text(const SceneResult& result, const Wish* wish) {
  const functional::Scene& scene = result.scene;
  std::string text =
      fmt::format("{}, frame {}: {}x{}, {} triangles cast{}; reference in {:.1f} s\n", scene.name,
                  scene.frame, scene.width, scene.height, grouped(result.triangles),
                  result.reference.size() > 1 ? fmt::format(", {} lights", result.reference.size())
                                              : std::string(),
                  result.reference_seconds);
  const std::vector<std::size_t> front = pareto_front(result.methods);
  Table table = new_table();
  std::string refused;
  for (std::size_t i = 0; i < result.methods.size(); ++i) {
    const Measured& measured = result.methods[i];
    if (measured.refused) {
      refused += fmt::format("  {} refused: {}\n", measured.choice.text, *measured.refused);
      continue;
    }
    table.add_row(row_of(measured, std::ranges::find(front, i) != front.end()));
  }
  text += table.text(2) + "  * no other is both faster and more exact\n" + refused;
  if (wish != nullptr) {
    const Recommendation found = recommend(result.methods, *wish);
    text += fmt::format("  {}: {}\n", found.method ? "recommended" : "none", found.why);
  }
  return text;
}

}  // namespace wedgesim::reports::accuracy
