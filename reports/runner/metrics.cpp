#include "reports/runner/metrics.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <set>

#include "reports/accesses.h"
#include "reports/runner/value.h"

namespace wedgesim::reports {
namespace {

Value integer(std::uint64_t number) { return static_cast<std::int64_t>(number); }

/// A metric besides the counters: how it follows from a result, and what it is.
template <typename Result>
struct Metric {
  std::string_view name, unit, description;
  std::function<Value(const Result&)> of;
};

double seconds_a_frame(const CyclesReport& report) {
  return static_cast<double>(std::max<model::memory::Cycle>(report.result.cycles, 1)) /
         (1e6 * report.config.clock_mhz);
}

double ratio(std::uint64_t part, std::uint64_t whole) {
  return whole == 0 ? 0.0 : static_cast<double>(part) / static_cast<double>(whole);
}

std::string z_name(bool fail) { return fail ? "fail" : "pass"; }

// clang-format off
using OfCount = Metric<model::CountResult>;
const std::vector<OfCount>& count_metrics() {
  static const std::vector<OfCount> metrics{
      {"z", "", "The z method taken", [](const auto& r) -> Value { return z_name(r.z == model::ZMethod::fail); }},
      {"accesses", "accesses", "z_reads + li_writes", [](const auto& r) { return integer(accesses_of(r).total()); }},
      {"accesses_floor", "accesses", "z_reads_floor + li_writes_floor", [](const auto& r) { return integer(floor_of(r)); }},
      {"over_floor", "", "accesses / accesses_floor", [](const auto& r) -> Value { const auto over = over_floor(r); if (!over) return {}; return *over; }},
      {"needless_visits", "visits", "Visits that a perfect culling would skip", [](const auto& r) { return integer(r.needless_visits); }},
      {"penumbra_z_reads", "accesses", "z_reads that penumbra faces ask for", [](const auto& r) { return integer(r.penumbra_z_reads); }},
      {"compared", "pixels", "Pixels compared with the expected LI", [](const auto& r) { return integer(r.pixels.compared); }},
      {"mismatched", "pixels", "Pixels beyond the tolerance and their own sensitivity", [](const auto& r) { return integer(r.pixels.mismatched); }},
      {"max_error", "full light", "Largest error of LI over all pixels", [](const auto& r) -> Value { return r.pixels.max_error; }},
      {"rms_error", "full light", "RMS error of LI over pixels of sensitivity up to 1/255", [](const auto& r) -> Value { return r.pixels.rms_error; }},
      {"rms_penumbra", "full light", "The same over those of them inside a wedge", [](const auto& r) -> Value { return r.pixels.rms_penumbra; }},
      {"tolerance", "full light", "What a pixel may be off besides its sensitivity", [](const auto& r) -> Value { return r.pixels.tolerance; }},
      {"wrong_contributions", "contributions", "Contributions that a wrong tile test lost or gained", [](const auto& r) { return integer(r.wrong_contributions); }},
      {"needless_visits", "visits", "What a perfect culling would skip", [](const auto& r) { return integer(r.needless_visits); }}};
  return metrics;
}

using OfCycles = Metric<CyclesReport>;
const std::vector<OfCycles>& cycles_metrics() {
  static const std::vector<OfCycles> metrics{
      {"z", "", "The z method taken", [](const auto& r) -> Value { return z_name(r.z_fail); }},
      {"cycles", "cycles", "From the first fetch to the last write", [](const auto& r) { return integer(r.result.cycles); }},
      {"frames_per_second", "1/s", "At the block's clock", [](const auto& r) -> Value { return 1.0 / seconds_a_frame(r); }},
      {"bottleneck", "", "What the frame's last cycle waited for longest: a unit, its memory, or the queue behind it", [](const auto& r) -> Value { return r.result.bottleneck().name; }},
      {"port_bytes", "bytes", "Lines at the memory port", [](const auto& r) { return integer(r.result.port_bytes()); }},
      {"port_gb_per_second", "GB/s", "port_bytes at the block's clock", [](const auto& r) -> Value { return static_cast<double>(r.result.port_bytes()) / seconds_a_frame(r) / 1e9; }},
      {"datapath_bytes", "bytes", "Counted words at their widths, which no cache saves", [](const auto& r) { return integer(r.datapath_bytes); }},
      {"floor_bytes", "bytes", "What every design must move", [](const auto& r) { return integer(r.floor_bytes); }},
      {"bytes_over_floor", "", "port_bytes / floor_bytes", [](const auto& r) -> Value { return ratio(r.result.port_bytes(), r.floor_bytes); }},
      {"busiest_bytes_per_cycle", "bytes/cycle", "Asked for at the port in its busiest cycles", [](const auto& r) -> Value { return r.peak_bytes_per_cycle; }},
      {"accesses", "accesses", "z_reads + li_writes", [](const auto& r) { return integer(r.counters().z_reads.value() + r.counters().li_writes.value()); }},
      {"compared", "pixels", "Pixels compared with the expected LI", [](const auto& r) { return integer(r.pixels.compared); }},
      {"mismatched", "pixels", "Pixels beyond the tolerance and their own sensitivity", [](const auto& r) { return integer(r.pixels.mismatched); }},
      {"max_error", "full light", "Largest error of LI over all pixels", [](const auto& r) -> Value { return r.pixels.max_error; }},
      {"tolerance", "full light", "What a pixel may be off besides its sensitivity", [](const auto& r) -> Value { return r.pixels.tolerance; }}};
  return metrics;
}
// clang-format on

/// Takes a metric with what is known of it.
using Take = std::function<void(MetricInfo info, Value value)>;

void take_counters(const model::Counters& counters, const Take& take) {
  for (const Counter* counter : counters.counters()) {
    take({std::string(counter->name()), std::string(name_of(counter->unit())),
          std::string(counter->description())},
         integer(counter->value()));
  }
}

template <typename Result>
void take_metrics(const std::vector<Metric<Result>>& metrics, const Result& result,
                  const Take& take) {
  for (const Metric<Result>& metric : metrics) {
    take({std::string(metric.name), std::string(metric.unit), std::string(metric.description)},
         metric.of(result));
  }
}

void take_units(const model::BlockResult& result, const Take& take) {
  for (const model::UnitResult& unit : result.units) {
    const std::pair<const char*, model::memory::Cycle> states[] = {{"busy", unit.busy},
                                                                   {"starved", unit.starved},
                                                                   {"stalled", unit.stalled},
                                                                   {"memory", unit.memory}};
    for (const auto& [state, cycles] : states) {
      take({fmt::format("{}.{}_cycles", unit.name, state), "cycles",
            fmt::format("Cycles in which {} is {}", unit.name,
                        state == std::string_view("memory") ? "stalled by memory" : state)},
           integer(cycles));
    }
    for (const model::Statistic& statistic : unit.statistics) {
      take({unit.name + '.' + statistic.name, statistic.unit, statistic.description},
           integer(statistic.value));
    }
  }
}

// "path.z_read", "path.memory.z_read"
void take_path(const model::BlockResult& result, const Take& take) {
  for (const model::PathShare& part : result.critical_path) {
    std::string name = "path." + part.name;
    std::ranges::replace(name, ':', '.');
    take({std::move(name), "cycles", "Cycles that the frame's end waited for it"},
         integer(part.cycles));
  }
}

void take_memory(const model::BlockResult& result, const Take& take) {
  for (const model::CacheResult& cache : result.caches) {
    const std::string name = "cache." + cache.name + '.';
    take({name + "hits", "accesses", "Found in the cache"}, integer(cache.hits));
    take({name + "misses", "accesses", "Not found in the cache"}, integer(cache.misses));
    take({name + "write_backs", "lines", "Changed lines written back"}, integer(cache.write_backs));
    take({name + "hit_rate", "", "hits / (hits + misses)"},
         ratio(cache.hits, cache.hits + cache.misses));
  }
  for (const model::TrafficResult& traffic : result.traffic) {
    const std::string name = "surface." + traffic.surface + '.';
    take({name + "reads", "accesses", "Lines read at the port"}, integer(traffic.reads));
    take({name + "writes", "accesses", "Lines written at the port"}, integer(traffic.writes));
    take({name + "read_bytes", "bytes", "Bytes of them"}, integer(traffic.read_bytes));
    take({name + "write_bytes", "bytes", "Bytes of them"}, integer(traffic.write_bytes));
  }
  for (const model::Statistic& statistic : result.memory) {
    take({"memory." + statistic.name, statistic.unit, statistic.description},
         integer(statistic.value));
  }
}

void take_all(const model::CountResult& result, const Take& take) {
  take_metrics(count_metrics(), result, take);
  take_counters(*result.counters, take);
}

void take_all(const CyclesReport& report, const Take& take) {
  take_metrics(cycles_metrics(), report, take);
  take_counters(report.counters(), take);
  take_units(report.result, take);
  take_path(report.result, take);
  take_memory(report.result, take);
}

template <typename Result>
Values values_of_result(const Result& result) {
  Values values;
  take_all(result, [&values](MetricInfo info, Value value) {
    values.emplace(std::move(info.name), std::move(value));  // the first of a name
  });
  return values;
}

// One lit pixel: what it gives has a name, and is nothing.
traces::Trace blank_trace() {
  traces::Trace trace;
  trace.header.width = trace.header.height = 1;
  trace.header.lights.emplace_back();
  trace.depth = {0};
  return trace;
}

}  // namespace

Values metrics_of(const model::CountResult& result) { return values_of_result(result); }
Values metrics_of(const CyclesReport& report) { return values_of_result(report); }

std::vector<MetricInfo> metrics_of(bool count, bool cycles) {
  std::vector<MetricInfo> metrics;
  std::set<std::string> names;
  const Take take = [&](MetricInfo info, const Value&) {
    if (names.insert(info.name).second) metrics.push_back(std::move(info));
  };
  if (count) {
    model::CountResult result;
    result.counters = std::make_unique<model::Counters>();
    take_all(result, take);
  }
  if (cycles) {
    const traces::Trace trace = blank_trace();
    for (const model::MemoryKind kind : {model::MemoryKind::ideal, model::MemoryKind::dram}) {
      model::BlockConfig config;
      config.memory.kind = kind;
      take_all(run_cycles(check_frame(trace.view(), config), config, {}), take);
    }
  }
  return metrics;
}

bool held(const PointRow& point) {
  const auto is_zero = [&point](std::string_view metric) {
    return number_of(find_value(point.metrics, metric)).value_or(0.0) == 0.0;
  };
  return is_zero("mismatched") && is_zero("wrong_contributions");
}

}  // namespace wedgesim::reports
