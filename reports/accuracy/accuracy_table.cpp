#include "reports/accuracy/accuracy_table.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "reports/table.h"

namespace wedgesim::reports::accuracy {
namespace {

std::string number(double value, int digits, const Errors& errors) {
  if (errors.values == 0) return "-";
  if (!std::isfinite(value)) return "inf";
  return fmt::format("{:.{}f}", value, digits);
}

std::string thousands(std::uint64_t count) { return grouped((count + 500) / 1000); }

}  // namespace

std::span<const Column> columns() {
  static constexpr std::array kColumns{Column{"", false},
                                       Column{"method", false},
                                       Column{"RMSE", true, "receivers"},
                                       Column{"max"},
                                       Column{"PSNR"},
                                       Column{">1/255 %"},
                                       Column{">16/255 %"},
                                       Column{"casters", true, "RMSE"},
                                       Column{"penumbra"},
                                       Column{"1 thread", true, "ms"},
                                       Column{"all"},
                                       Column{"z reads", true, "thousands"},
                                       Column{"LI writes"},
                                       Column{"map writes"},
                                       Column{"MB", true, "traffic"},
                                       Column{"MB", true, "memory"}};
  return kColumns;
}

std::vector<std::string> cells_of(const Measured& measured, bool on_front) {
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

std::string facts_of(const SceneResult& result) {
  const std::size_t lights = result.reference.size();
  return fmt::format("{}x{}, {} triangles cast{}; reference in {:.1f} s", result.scene.width,
                     result.scene.height, grouped(result.triangles),
                     lights > 1 ? fmt::format(", {} lights", lights) : std::string(),
                     result.reference_seconds);
}

}  // namespace wedgesim::reports::accuracy
