#include "reports/page/timeline_file.h"

#include <algorithm>

#include "base/file.h"
#include "reports/cycles.h"
#include "reports/page/findings.h"
#include "reports/runner/configuration.h"
#include "reports/runner/frames.h"
#include "reports/timeline.h"
#include "traces/reader.h"

namespace wedgesim::reports::page {
namespace {

constexpr std::uint64_t kCycles = 20000;  // a viewer opens them at once

Configuration configuration_of(const PointRow& point) {
  Settings settings;
  for (const auto& [key, value] : point.configuration) settings.push_back({key, value, 0});
  return make_configuration(point.frame, Measure::cycles, settings, settings.size());
}

// The first point of the best configuration whose trace is there; null if there is none.
const PointRow* best_point(const Columns& columns, const std::filesystem::path& folder) {
  const auto best = find_best(columns);
  if (!best || columns.number("cycles") == nullptr) return nullptr;
  for (std::size_t i = 0; i < columns.points(); ++i) {
    const PointRow& point = columns.results().points[i];
    const bool is_best = std::ranges::all_of(best->settings, [i](const auto& setting) {
      return setting.first->values[i] == setting.second;
    });
    if (is_best && columns.done(i) && point.measure == "cycles" &&
        std::filesystem::is_regular_file(trace_path(folder, point.frame))) {
      return &point;
    }
  }
  return nullptr;
}

}  // namespace

void write_timeline(const Columns& columns, const std::filesystem::path& folder) {
  const PointRow* point = best_point(columns, folder);
  if (point == nullptr) return;
  const traces::TraceFile trace(trace_path(folder, point->frame));
  const model::BlockConfig block = configuration_of(*point).block;
  Timeline timeline(0, kCycles, model::kBlockUnits);
  model::BlockOptions options;
  options.states = [&timeline](std::string_view unit, model::units::UnitState state,
                               model::memory::Cycle begin,
                               model::memory::Cycle end) { timeline.add(unit, state, begin, end); };
  run_cycles(check_frame(trace.view(), block), block, options);
  write_stream(folder / "timeline.json",
               [&timeline](std::ostream& out) { timeline.write_chrome(out); });
}

}  // namespace wedgesim::reports::page
